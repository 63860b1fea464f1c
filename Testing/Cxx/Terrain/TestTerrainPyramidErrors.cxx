// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainPyramid promises errors for invalid rasters and calls, and returns NaN or infinity for
// them.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTerrainPyramid.h"

#include <cmath>
#include <filesystem>
#include <fstream>

namespace
{
void ExpectError(
  RelevoCheck& check, vtkTerrainPyramid* pyramid, const std::string& name, const char* reason)
{
  CHECK_CASE(name);
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(name.c_str());
  CHECK(!pyramid->Update());
  CHECK(errors.Said(reason));
  CHECK_EQUAL(pyramid->GetDimensions()[0], 0);
  CHECK_EQUAL(pyramid->GetNumberOfLevels(), 0);
  CHECK(!pyramid->IsErrorKnown());
  CHECK(std::isinf(pyramid->GetMaximumError(0)));
  CHECK(std::isnan(pyramid->GetElevation(0.0, 0.0)));
  CHECK_EQUAL(std::string(pyramid->GetCoordinateSystem()), std::string());
}

void TestFiles(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  {
    RelevoErrors errors(pyramid);
    CHECK(!pyramid->Update());
    CHECK(errors.Said("call SetFileName()"));
    CHECK(!pyramid->WaitForIndex());
    CHECK(errors.Said("call Update() first"));
  }
  const std::string text = folders.File("TerrainPyramidText.txt");
  std::ofstream(text) << "no raster\n";
  const std::string empty = folders.File("TerrainPyramidEmpty.tif");
  std::ofstream(empty) << "";
  ExpectError(check, pyramid, folders.File("TerrainPyramidMissing.tif"), "does not exist");
  ExpectError(check, pyramid, folders.Output, "folder");
  ExpectError(check, pyramid, text, "TerrainPyramidText.txt");
  ExpectError(check, pyramid, empty, "empty");
}

// A truncated file is not opened, in any layout, also if only overviews are cut off. A damaged file
// is read as far as possible, and the rest is one error. It counts as missing data, and the index
// is not written.
void TestTruncated(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string whole = folders.File("TerrainPyramidWhole.tif");
  const std::string cut = folders.File("TerrainPyramidCut.tif");
  RelevoRaster raster = RelevoRaster::MakeSlope(600, 600, {}, "");
  raster.Type = GDT_Int16;
  CHECK(raster.Write(whole));
  RelevoTruncate(whole, cut, 0.6);
  vtkNew<vtkTerrainPyramid> pyramid;
  ExpectError(check, pyramid, cut, "truncated");

  for (const char* layout : { "TILED=NO", "TILED=YES" })
  {
    CHECK_CASE(layout);
    raster.Options = { "COMPRESS=DEFLATE", layout };
    CHECK(raster.Write(whole));
    for (const double share : { 0.4, 0.6, 0.99 })
    {
      CHECK_CASE(share);
      RelevoTruncate(whole, cut, share);
      vtkNew<vtkTerrainPyramid> other;
      ExpectError(check, other, cut, "the file is truncated: it has ");
    }
    GDALDatasetH dataset = GDALOpen(whole.c_str(), GA_Update);
    const int factors[] = { 2 };
    CHECK(GDALBuildOverviews(dataset, "AVERAGE", 1, factors, 0, nullptr, nullptr, nullptr) == 0);
    GDALClose(dataset);
    vtkNew<vtkTerrainPyramid> good;
    RelevoErrors none(good);
    good->SetFileName(whole.c_str());
    CHECK(good->Update());
    CHECK_EQUAL(good->GetNumberOfLevels(), 2);
    CHECK(none.None());
    RelevoTruncate(whole, cut, 0.95);
    vtkNew<vtkTerrainPyramid> other;
    ExpectError(check, other, cut, "the file is truncated: it has ");
  }

  raster.Options = { "COMPRESS=DEFLATE" };
  CHECK(raster.Write(whole));
  RelevoTruncate(whole, cut, 0.6);
  std::filesystem::resize_file(cut, std::filesystem::file_size(whole)); // the rest is zeros
  std::filesystem::remove(cut + ".relevo-index");
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(cut.c_str());
  pyramid->Update();
  CHECK(!pyramid->WaitForIndex());
  CHECK(errors.Said("TerrainPyramidCut.tif"));
  CHECK(pyramid->IsErrorKnown());
  CHECK_EQUAL(pyramid->GetMaximumError(0), 0.0);
  CHECK_EQUAL(pyramid->GetRange()[0], 0.0);
  CHECK_GREATER(pyramid->GetRange()[1], 600.0);
  CHECK_LESS(pyramid->GetRange()[1], 1150.0);
  CHECK(errors.None()); // no second report
  CHECK(!pyramid->Update());
  CHECK(!pyramid->WaitForIndex());
  CHECK(errors.None());
  CHECK_EQUAL(pyramid->GetElevation(10.5, 599.5), raster.At(0, 10, 0));
  CHECK(errors.None());
  CHECK(std::isnan(pyramid->GetElevation(10.5, 0.5)));
  CHECK(errors.Said("TerrainPyramidCut.tif"));
  CHECK(!std::filesystem::exists(cut + ".relevo-index"));
}

// A raster in metres that is declared as longitude and latitude is not indexed. Half a sample
// beyond a pole is right for samples on grid lines.
void TestLatitudes(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("TerrainPyramidLatitudes.tif");
  CHECK(
    RelevoRaster::MakeSlope(300, 200, { 500000.0, 30.0, 0.0, 4300000.0, 0.0, -30.0 }, "EPSG:4326")
      .Write(name));
  std::filesystem::remove(name + ".relevo-index");
  vtkNew<vtkTerrainPyramid> pyramid;
  ExpectError(check, pyramid, name, "latitudes beyond the poles");
  RelevoErrors errors(pyramid);
  CHECK(!pyramid->Update());
  CHECK(errors.None()); // once
  CHECK(std::string(pyramid->GetErrorMessage()).find("gdal_translate -a_srs") != std::string::npos);
  CHECK(!std::filesystem::exists(name + ".relevo-index"));

  CHECK(RelevoRaster::MakeSlope(73, 37, { -182.5, 5.0, 0.0, 92.5, 0.0, -5.0 }, "EPSG:4326")
          .Write(name));
  CHECK(pyramid->Update());
  CHECK(errors.None());
}

void TestCalls(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("TerrainPyramidCalls.tif");
  CHECK(RelevoRaster::MakeSlope(40, 30, {}, "").Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors errors(pyramid);
  pyramid->SetMemoryLimit(1000);
  CHECK(errors.Said("MemoryLimit must be at least 1048576, got 1000."));
  CHECK_EQUAL(pyramid->GetMemoryLimit(), vtkTypeInt64(1) << 28);
  vtkNew<vtkDoubleArray> points;
  CHECK(!pyramid->GetElevations(points));
  CHECK(errors.Said("call Update() first"));
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK(!pyramid->GetElevations(nullptr));
  CHECK(errors.Said("2 components"));
  points->SetNumberOfComponents(3);
  CHECK(!pyramid->GetElevations(points));
  CHECK(errors.Said("2 components"));
  int dimensions[2] = { 1, 1 };
  pyramid->GetLevelDimensions(1, dimensions);
  CHECK_EQUAL(dimensions[0], 0);
  CHECK(std::isinf(pyramid->GetMaximumError(1)));
  CHECK(std::isinf(pyramid->GetMaximumError(-1)));
  CHECK(errors.None());
}

// If the source of a VRT changes, reading heights fails until Update() opens it again and rebuilds
// the index. A separate file of statistics, as GDAL writes it, has no effect.
void TestSources(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string source = folders.File("TerrainPyramidSource.tif");
  const std::string name = folders.File("TerrainPyramidSources.vrt");
  CHECK(RelevoRaster::MakeSlope(40, 30, {}, "").Write(source));
  std::ofstream(name) << "<VRTDataset rasterXSize='40' rasterYSize='30'>"
                         "<VRTRasterBand dataType='Float32' band='1'><SimpleSource>"
                         "<SourceFilename relativeToVRT='1'>TerrainPyramidSource.tif"
                         "</SourceFilename><SourceBand>1</SourceBand>"
                         "</SimpleSource></VRTRasterBand></VRTDataset>";
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  const double first = pyramid->GetElevation(10.5, 10.5);
  std::ofstream(name + ".aux.xml") << "<PAMDataset></PAMDataset>";
  CHECK(pyramid->Update());
  CHECK_EQUAL(pyramid->GetElevation(10.5, 10.5), first);
  CHECK(errors.None());

  CHECK(RelevoRaster::MakeSlope(40, 30, {}, "", 5000.0).Write(source));
  vtkNew<vtkTerrainPyramid> other; // no tile is cached
  RelevoErrors otherErrors(other);
  other->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK_EQUAL(pyramid->GetElevation(10.5, 10.5), first + 5000.0);
  CHECK_EQUAL(pyramid->GetRange()[0], 5000.0);
  CHECK(other->Update());
  CHECK(other->IsErrorKnown());
  CHECK(RelevoRaster::MakeSlope(40, 30, {}, "", 7000.0).Write(source));
  CHECK(std::isnan(other->GetElevation(10.5, 10.5)));
  CHECK(otherErrors.Said("has changed since it was opened"));
  CHECK(errors.None());
  std::filesystem::remove(name + ".aux.xml");
}

// A raster without any data, and one of a single sample.
void TestExtremes(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("TerrainPyramidExtremes.tif");
  RelevoRaster raster = RelevoRaster::MakeSlope(300, 20, {}, "");
  raster.NoData = 5.0;
  raster.SetValues([](int, int, int) { return 5.0; });
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK_EQUAL(pyramid->GetRange()[0], 0.0);
  CHECK_EQUAL(pyramid->GetRange()[1], 0.0);
  CHECK(std::isnan(pyramid->GetElevation(3.5, 3.5)));

  CHECK(RelevoRaster::MakeSlope(1, 1, {}, "", 7.0).Write(name));
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK_EQUAL(pyramid->GetRange()[1], 7.0);
  CHECK_EQUAL(pyramid->GetElevation(0.1, 0.9), 7.0);
  CHECK(errors.None());
}
}

int TestTerrainPyramidErrors(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestFiles(check, folders);
  TestTruncated(check, folders);
  TestLatitudes(check, folders);
  TestCalls(check, folders);
  TestSources(check, folders);
  TestExtremes(check, folders);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightMap promises an error that names file and cause for files that it cannot read, and no
// heights of an earlier file.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkHeightMap.h"

#include <OpenImageIO/imageio.h>
#include <fstream>
#include <iostream>

namespace
{
// The error names the file and the cause, and the map has no heights.
void ExpectError(
  RelevoCheck& check, vtkHeightMap* map, const std::string& name, const std::string& reason)
{
  RelevoErrors errors(map);
  map->SetFileName(name.c_str());
  CHECK(!map->Update());
  if (!CHECK(errors.Said(name)))
  {
    std::cerr << "  for " << name << "\n";
  }
  CHECK(!map->Update());
  CHECK(errors.Said(reason));
  CHECK(map->GetDimensions()[0] == 0 && map->GetDimensions()[1] == 0);
  CHECK(!map->GetSamples() && !map->GetValidity() && !map->HasNoData());
  CHECK(map->GetHeight(0.5, 0.5) == 0.0 && !map->IsValid(0.5, 0.5));
}

// A map that reads a valid file between invalid ones, and the raster of that file.
struct Scene
{
  Scene(RelevoCheck& check, const RelevoTestFolders& folders)
    : Good(folders.File("HeightMapErrorsGood.tif"))
  {
    this->Raster.Width = 120;
    this->Raster.Height = 300;
    this->Raster.Type = GDT_UInt16;
    this->Raster.SetValues(
      [](int, int column, int row) { return (column * 977 + row * 131) % 60000; });
    CHECK(this->Raster.Write(this->Good));
  }
  void ExpectGood(RelevoCheck& check)
  {
    RelevoErrors errors(this->Map);
    this->Map->SetFileName(this->Good.c_str());
    CHECK(this->Map->Update() && errors.None());
    CHECK(this->Map->GetDimensions()[0] == 120 && this->Map->GetDimensions()[1] == 300);
  }

  std::string Good;
  RelevoRaster Raster;
  vtkNew<vtkHeightMap> Map;
};

// Missing files, folders and text.
void TestNoImages(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  scene.ExpectGood(check);
  ExpectError(check, scene.Map, folders.File("no such file.tif"), "does not exist");
  scene.ExpectGood(check);
  ExpectError(check, scene.Map, folders.Output, "folder");
  const std::string empty = folders.File("HeightMapEmpty.tif");
  std::ofstream(empty).close();
  ExpectError(check, scene.Map, empty, "empty");
  for (const char* extension : { "tif", "png", "exr", "hgt", "dem", "txt" })
  {
    CHECK_CASE(extension);
    const std::string text = folders.File(std::string("HeightMapText.") + extension);
    std::ofstream(text) << "This is no image, whatever its name may say.\n"
                        << std::string(4000, 'x');
    ExpectError(check, scene.Map, text, "Cannot read");
  }
  scene.ExpectGood(check);
}

// In all layouts.
void TestTruncatedTIFF(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  RelevoRaster raster = scene.Raster;
  for (const char* compression : { "NONE", "LZW", "DEFLATE" })
  {
    CHECK_CASE(compression);
    for (const char* tiled : { "NO", "YES" })
    {
      CHECK_CASE(tiled);
      raster.Options = { std::string("COMPRESS=") + compression, std::string("TILED=") + tiled };
      const std::string whole = folders.File("HeightMapWhole.tif");
      const std::string half = folders.File("HeightMapHalf.tif");
      CHECK(raster.Write(whole));
      for (double share : { 0.001, 0.3, 0.9 })
      {
        CHECK_CASE(share);
        RelevoTruncate(whole, half, share);
        ExpectError(check, scene.Map, half, "Cannot read");
      }
    }
  }
}

// PNG, EXR and SRTM files.
void TestTruncated(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  const std::string png = folders.File("HeightMapWhole.png");
  CHECK(scene.Raster.Write(png, "PNG"));
  RelevoTruncate(png, folders.File("HeightMapHalf.png"), 0.5);
  ExpectError(check, scene.Map, folders.File("HeightMapHalf.png"), "Cannot read");
  const std::string exr = folders.File("HeightMapWhole.exr");
  auto output = OIIO::ImageOutput::create(exr);
  const std::vector<float> values(scene.Raster.Values.begin(), scene.Raster.Values.end());
  CHECK(output && output->open(exr, OIIO::ImageSpec(120, 300, 1, OIIO::TypeDesc::FLOAT)) &&
    output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
  RelevoTruncate(exr, folders.File("HeightMapHalf.exr"), 0.5);
  ExpectError(check, scene.Map, folders.File("HeightMapHalf.exr"), "Cannot read");
  const std::string hgt = folders.File("N10E020.hgt");
  std::ofstream(hgt, std::ios::binary) << std::string(1201 * 1000, '\0');
  ExpectError(check, scene.Map, hgt, "Cannot read");
  scene.ExpectGood(check);
}

// Rasters of complex numbers are not supported.
void TestComplex(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  RelevoRaster complex = scene.Raster;
  complex.Type = GDT_CFloat32;
  const std::string name = folders.File("HeightMapComplex.tif");
  CHECK(complex.Write(name));
  ExpectError(check, scene.Map, name, "not supported");
}

// Headers that declare more data than the file contains, or than a computer can store.
void TestPromises(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  for (const char* size : { "rasterXSize=\"2000000000\" rasterYSize=\"1\"",
         "rasterXSize=\"2000000000\" rasterYSize=\"2000000000\"",
         "rasterXSize=\"0\" rasterYSize=\"0\"", "rasterXSize=\"1\" rasterYSize=\"-3\"" })
  {
    CHECK_CASE(size);
    const std::string promise = folders.File("HeightMapPromise.vrt");
    std::ofstream(promise) << "<VRTDataset " << size
                           << "><VRTRasterBand dataType=\"Float64\" band=\"1\"><SimpleSource>"
                              "<SourceFilename relativeToVRT=\"1\">no such file.tif"
                              "</SourceFilename><SourceBand>1</SourceBand></SimpleSource>"
                              "</VRTRasterBand></VRTDataset>";
    ExpectError(check, scene.Map, promise, "Cannot read");
  }
}

// Reports progress. Aborting is not an error, and the next update works.
void TestStop(RelevoCheck& check, Scene& scene)
{
  double progress = 0.0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&progress);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* share)
    {
      *static_cast<double*>(client) = *static_cast<double*>(share);
      static_cast<vtkHeightMap*>(caller)->AbortExecuteOn();
    });
  vtkHeightMap* map = scene.Map;
  const unsigned long tag = map->AddObserver(vtkCommand::ProgressEvent, observer);
  {
    RelevoErrors errors(map);
    map->SetFileName(scene.Good.c_str());
    CHECK(!map->Update() && errors.None());
    CHECK_GREATER(progress, 0.0);
    CHECK_LESS_EQUAL(progress, 1.0);
    CHECK(!map->GetSamples());
  }
  map->RemoveObserver(tag);
  CHECK(map->Update() && map->GetSamples());
}
}

int TestHeightMapErrors(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  Scene scene(check, folders);
  TestNoImages(check, folders, scene);
  TestTruncatedTIFF(check, folders, scene);
  TestTruncated(check, folders, scene);
  TestComplex(check, folders, scene);
  TestPromises(check, folders, scene);
  TestStop(check, scene);
  return check.GetResult();
}

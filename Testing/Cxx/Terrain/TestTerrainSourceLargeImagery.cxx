// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves terrain.md: imagery larger than MaximumImagerySize is reduced without shift, from
// overviews if the file has any, with one warning.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoWarnings.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Extent[2] = { 60000.0, 30000.0 }; // metres, of terrain and pictures

int Color(vtkImageData* image, int i, int j, int component)
{
  return static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0))[component];
}

std::string WriteTerrain(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 60;
  raster.Height = 30;
  raster.Transform = { 500000.0, 1000.0, 0.0, 5000000.0, 0.0, -1000.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.SetValues([](int, int column, int row) { return column + row; });
  const std::string name = folders.File("LargeImageryTerrain.tif");
  CHECK(raster.Write(name));
  return name;
}

// Red encodes the distance to the east and green that to the north, at every size.
void TestReduced(RelevoCheck& check, const RelevoTestFolders& folders, const std::string& terrain)
{
  for (const char* driver : { "GTiff", "PNG" })
  {
    CHECK_CASE(driver);
    const bool isLocated = driver == std::string("GTiff");
    RelevoRaster picture;
    picture.Width = 1500;
    picture.Height = 750;
    picture.NumberOfBands = 3;
    picture.Type = GDT_Byte;
    if (isLocated)
    {
      picture.Transform = { 500000.0, Extent[0] / 1500, 0.0, 5000000.0, 0.0, -Extent[1] / 750 };
      picture.CoordinateSystem = "EPSG:32633";
    }
    picture.SetValues(
      [](int band, int column, int row)
      {
        return band == 0 ? std::floor(250.0 * (column + 0.5) / 1500)
          : band == 1    ? std::floor(250.0 * (749.5 - row) / 750)
                         : 77.0;
      });
    const std::string name = folders.File(isLocated ? "LargeImagery.tif" : "LargeImagery.png");
    CHECK(picture.Write(name, driver));
    vtkNew<vtkTerrainSource> source;
    RelevoWarnings warnings(source);
    source->SetFileName(terrain.c_str());
    source->SetImageryFileName(name.c_str());
    source->Update();
    CHECK(warnings.Number == 0 && source->GetImagery()->GetDimensions()[0] == 1500);
    source->SetMaximumImagerySize(600);
    source->Update();
    source->Update();
    CHECK_EQUAL(warnings.Number, 1);
    for (const char* words : { "1500 x 750", "600 per side", "600 x 600", "MaximumImagerySize" })
    {
      CHECK_CASE(words);
      CHECK_NOT_EQUAL(warnings.Text.find(words), std::string::npos);
    }
    vtkImageData* image = source->GetImagery();
    CHECK(image->GetDimensions()[0] == 600 && image->GetDimensions()[1] == 600);
    int worst = 0;
    for (int j = 0; j < 600; j += 7)
    {
      for (int i = 0; i < 600; i += 7)
      {
        const double red = 250.0 * (i + 0.5) / 600 - 0.5;
        const double green = 250.0 * (j + 0.5) / 600 - 0.5;
        worst = std::max({ worst, static_cast<int>(std::abs(Color(image, i, j, 0) - red)),
          static_cast<int>(std::abs(Color(image, i, j, 1) - green)),
          std::abs(Color(image, i, j, 2) - 77) });
      }
    }
    CHECK_LESS_EQUAL(worst, 1);
  }
}

// 1800 million pixels, which are not read. The overview has another colour, which shows that it is
// used.
void TestOverviews(RelevoCheck& check, const RelevoTestFolders& folders, const std::string& terrain)
{
  const std::string name = folders.File("LargeImageryOverviews.tif");
  char** options = nullptr;
  for (const char* option :
    { "TILED=YES", "SPARSE_OK=TRUE", "COMPRESS=DEFLATE", "PHOTOMETRIC=RGB", "BIGTIFF=YES" })
  {
    options = CSLAddString(options, option);
  }
  GDALDatasetH dataset =
    GDALCreate(GDALGetDriverByName("GTiff"), name.c_str(), 60000, 30000, 3, GDT_Byte, options);
  CSLDestroy(options);
  double transform[6] = { 500000.0, 1.0, 0.0, 5000000.0, 0.0, -1.0 };
  GDALSetGeoTransform(dataset, transform);
  const int factors[2] = { 30, 240 };
  CHECK_EQUAL(
    GDALBuildOverviews(dataset, "NONE", 2, factors, 0, nullptr, nullptr, nullptr), CE_None);
  for (int band = 1; band <= 3; ++band)
  {
    for (int level = 0; level < 2; ++level)
    {
      CHECK_EQUAL(GDALFillRaster(GDALGetOverview(GDALGetRasterBand(dataset, band), level),
                    50.0 * band + 10.0 * level, 0.0),
        CE_None);
    }
  }
  GDALClose(dataset);
  vtkNew<vtkTerrainSource> source;
  RelevoWarnings warnings(source);
  source->SetFileName(terrain.c_str());
  source->SetImageryFileName(name.c_str());
  for (const auto& size : { std::pair<int, int>{ 800, 0 }, { 100, 10 } })
  {
    warnings.Number = 0;
    source->SetMaximumImagerySize(size.first);
    source->Update();
    CHECK(warnings.Number == 1 && warnings.Text.find("60000 x 30000") != std::string::npos);
    vtkImageData* image = source->GetImagery();
    CHECK_EQUAL(image->GetDimensions()[0], size.first);
    for (int place : { 0, size.first / 2, size.first - 1 })
    {
      CHECK_CASE(place);
      for (int band = 0; band < 3; ++band)
      {
        CHECK_EQUAL(
          Color(image, place, size.first - 1 - place, band), 50 * (band + 1) + size.second);
      }
    }
  }
}
}

int TestTerrainSourceLargeImagery(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  const std::string terrain = WriteTerrain(check, folders);
  TestReduced(check, folders, terrain);
  TestOverviews(check, folders, terrain);
  return check.GetResult();
}

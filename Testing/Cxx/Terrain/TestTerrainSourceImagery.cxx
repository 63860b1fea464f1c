// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainSource promises imagery whose colours appear at the right coordinates.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>

namespace
{
constexpr int Grey = 128;

int Color(vtkImageData* image, int i, int j, int component)
{
  return static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0))[component];
}

RelevoRaster MakePicture(int width, int height, int bands, const std::vector<double>& transform,
  const std::string& coordinateSystem)
{
  RelevoRaster raster = RelevoRaster::MakeSlope(width, height, transform, coordinateSystem);
  raster.Type = GDT_Byte;
  raster.NumberOfBands = bands;
  raster.SetValues(
    [](int band, int column, int row) { return (17 * column + 29 * row + 71 * band) % 250; });
  return raster;
}

vtkImageData* Drape(
  vtkTerrainSource* source, const std::string& terrain, const std::string& picture)
{
  source->SetFileName(terrain.c_str());
  source->SetImageryFileName(picture.c_str());
  source->Update();
  return source->GetImagery();
}

// Whether the image has the picture's bands, pixel by pixel, with its last row first.
bool SamePixels(vtkImageData* image, const RelevoRaster& picture, const std::array<int, 3>& bands)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (dimensions[0] != picture.Width || dimensions[1] != picture.Height ||
    image->GetScalarType() != VTK_UNSIGNED_CHAR || image->GetNumberOfScalarComponents() != 3)
  {
    std::cerr << "the image is " << dimensions[0] << " x " << dimensions[1] << "\n";
    return false;
  }
  for (int row = 0; row < picture.Height; ++row)
  {
    for (int column = 0; column < picture.Width; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        const int color = Color(image, column, picture.Height - 1 - row, c);
        if (color != picture.At(bands[c], column, row))
        {
          std::cerr << "column " << column << ", row " << row << ", component " << c << ": "
                    << color << ", expected " << picture.At(bands[c], column, row) << "\n";
          return false;
        }
      }
    }
  }
  return true;
}

// A picture on the terrain's grid or without georeference is unchanged.
void TestSameGrid(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string terrain = folders.File("ImageryTerrain.tif");
  const std::string file = folders.File("Imagery.tif");
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  vtkNew<vtkTerrainSource> source;
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive()); // repeats every error

  CHECK(RelevoRaster::MakeSlope(40, 30, utm, "EPSG:32633").Write(terrain));
  const RelevoRaster rgb = MakePicture(40, 30, 3, utm, "EPSG:32633");
  CHECK(rgb.Write(file));
  CHECK(SamePixels(Drape(source, terrain, file), rgb, { 0, 1, 2 }));

  // A finer picture keeps its resolution.
  const RelevoRaster fine =
    MakePicture(160, 120, 3, { 500000.0, 2.5, 0.0, 5000000.0, 0.0, -2.5 }, "EPSG:32633");
  CHECK(fine.Write(folders.File("ImageryFine.tif")));
  CHECK(SamePixels(Drape(source, terrain, folders.File("ImageryFine.tif")), fine, { 0, 1, 2 }));

  // Bands can be chosen in any order.
  const RelevoRaster six = MakePicture(40, 30, 6, utm, "EPSG:32633");
  CHECK(six.Write(folders.File("ImagerySix.tif")));
  CHECK(SamePixels(Drape(source, terrain, folders.File("ImagerySix.tif")), six, { 2, 1, 0 }));
  source->SetImageryBands(6, 2, 4);
  CHECK(SamePixels(Drape(source, terrain, folders.File("ImagerySix.tif")), six, { 5, 1, 3 }));
  source->SetImageryBands(1, 2, 7);
  source->Update();
  CHECK(errors.Said("no band 7; it has 6 bands"));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 0);
  source->SetImageryBands(0, 0, 0);

  // A single band is grey.
  const RelevoRaster one = MakePicture(40, 30, 1, utm, "EPSG:32633");
  CHECK(one.Write(folders.File("ImageryOne.tif")));
  CHECK(SamePixels(Drape(source, terrain, folders.File("ImageryOne.tif")), one, { 0, 0, 0 }));

  // Neither terrain nor picture has a georeference.
  const RelevoRaster plain = MakePicture(64, 32, 3, {}, "");
  CHECK(plain.Write(folders.File("Imagery.png"), "PNG"));
  CHECK(RelevoRaster::MakeSlope(40, 30, {}, "").Write(folders.File("ImageryPlain.tif")));
  CHECK(SamePixels(Drape(source, folders.File("ImageryPlain.tif"), folders.File("Imagery.png")),
    plain, { 0, 1, 2 }));
  // Only the terrain has one.
  CHECK(SamePixels(Drape(source, terrain, folders.File("Imagery.png")), plain, { 0, 1, 2 }));
  // Only the picture has one.
  CHECK(SamePixels(Drape(source, folders.File("ImageryPlain.tif"), folders.File("ImagerySix.tif")),
    six, { 2, 1, 0 }));
  CHECK(errors.None());

  // Reduces the picture by averaging, which keeps the mean.
  source->SetMaximumImagerySize(16);
  vtkImageData* small =
    Drape(source, folders.File("ImageryPlain.tif"), folders.File("Imagery.png"));
  CHECK(small->GetDimensions()[0] == 16 && small->GetDimensions()[1] == 16);
  double mean = 0.0;
  for (int j = 0; j < 16; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      mean += Color(small, i, j, 0) / 256.0;
    }
  }
  double expected = 0.0;
  for (int i = 0; i < 64 * 32; ++i)
  {
    expected += plain.Values[i] / (64 * 32);
  }
  CHECK_NEAR(mean, expected, 4.0);
}

// A picture in UTM over a terrain in degrees. Its colours encode longitude and latitude.
void TestOtherCoordinateSystem(RelevoCheck& check, const RelevoTestFolders& folders)
{
  OGRSpatialReferenceH utm = OSRNewSpatialReference(nullptr);
  OSRImportFromEPSG(utm, 32633);
  OSRSetAxisMappingStrategy(utm, OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReferenceH degrees = OSRNewSpatialReference(nullptr);
  OSRImportFromEPSG(degrees, 4326);
  OSRSetAxisMappingStrategy(degrees, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH toDegrees = OCTNewCoordinateTransformation(utm, degrees);

  // The terrain covers 14.0 to 14.2 east and 45.0 to 45.1 north. The picture covers it except in
  // the west.
  const auto red = [](double longitude) { return (longitude - 13.9) / 0.4 * 250.0; };
  const auto green = [](double latitude) { return (latitude - 44.9) / 0.3 * 250.0; };
  RelevoRaster picture =
    MakePicture(220, 160, 3, { 425000.0, 100.0, 0.0, 4997000.0, 0.0, -100.0 }, "EPSG:32633");
  std::vector<double> longitudes;
  std::vector<double> latitudes;
  for (int row = 0; row < picture.Height; ++row)
  {
    for (int column = 0; column < picture.Width; ++column)
    {
      double x = 425000.0 + 100.0 * (column + 0.5);
      double y = 4997000.0 - 100.0 * (row + 0.5);
      OCTTransform(toDegrees, 1, &x, &y, nullptr);
      longitudes.push_back(x);
      latitudes.push_back(y);
    }
  }
  picture.SetValues(
    [&](int band, int column, int row)
    {
      const std::size_t index = static_cast<std::size_t>(row) * picture.Width + column;
      return band == 0 ? std::round(red(longitudes[index]))
        : band == 1    ? std::round(green(latitudes[index]))
                       : 7.0;
    });
  OCTDestroyCoordinateTransformation(toDegrees);
  OSRDestroySpatialReference(degrees);
  OSRDestroySpatialReference(utm);
  const std::string pictureName = folders.File("ImageryUTM.tif");
  const std::string terrainName = folders.File("ImageryDegrees.tif");
  CHECK(picture.Write(pictureName));
  CHECK(RelevoRaster::MakeSlope(50, 25, { 14.0, 0.004, 0.0, 45.1, 0.0, -0.004 }, "EPSG:4326")
          .Write(terrainName));

  vtkNew<vtkTerrainSource> source;
  vtkImageData* image = Drape(source, terrainName, pictureName);
  int dimensions[3];
  image->GetDimensions(dimensions);
  // The resolution is close to the picture's: 15.8 km by 11.1 km at 100 m.
  CHECK_NEAR(dimensions[0], 158.0, 3.0);
  CHECK_NEAR(dimensions[1], 112.0, 3.0);
  double worst = 0.0;
  int covered = 0;
  int uncovered = 0;
  for (int j = 0; j < dimensions[1]; ++j)
  {
    for (int i = 0; i < dimensions[0]; ++i)
    {
      const double longitude = 14.0 + 0.2 * (i + 0.5) / dimensions[0];
      const double latitude = 45.0 + 0.1 * (j + 0.5) / dimensions[1];
      // The picture's western border, 425 km east in zone 33, lies between 14.05 and 14.06 here.
      if (longitude > 14.07)
      {
        worst = std::max({ worst, std::abs(Color(image, i, j, 0) - red(longitude)),
          std::abs(Color(image, i, j, 1) - green(latitude)) });
        CHECK_EQUAL(Color(image, i, j, 2), 7);
        ++covered;
      }
      else if (longitude < 14.03)
      {
        CHECK_EQUAL(Color(image, i, j, 0), Grey);
        CHECK_EQUAL(Color(image, i, j, 1), Grey);
        CHECK_EQUAL(Color(image, i, j, 2), Grey);
        ++uncovered;
      }
    }
  }
  CHECK_GREATER(covered, 1000);
  CHECK_GREATER(uncovered, 1000);
  CHECK_NEAR(worst, 0.0, 1.01); // rounded twice
}

// Missing data, transparency, palettes and wider types.
void TestPixels(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  const std::string terrain = folders.File("ImageryPixelsTerrain.tif");
  CHECK(RelevoRaster::MakeSlope(8, 8, utm, "EPSG:32633").Write(terrain));
  vtkNew<vtkTerrainSource> source;

  RelevoRaster voids = MakePicture(8, 8, 3, utm, "EPSG:32633");
  voids.NoData = 255.0;
  voids.SetValues([](int band, int column, int row)
    { return column < 3 || (row == 2 && band == 1) ? 255.0 : 10.0 * band + column; });
  CHECK(voids.Write(folders.File("ImageryVoids.tif")));
  vtkImageData* image = Drape(source, terrain, folders.File("ImageryVoids.tif"));
  CHECK_EQUAL(Color(image, 1, 4, 0), Grey);
  CHECK_EQUAL(Color(image, 1, 4, 2), Grey);
  CHECK_EQUAL(Color(image, 6, 4, 0), 6);
  CHECK_EQUAL(Color(image, 6, 4, 2), 26);
  CHECK_EQUAL(Color(image, 6, 5, 1), 255);
  CHECK_EQUAL(Color(image, 6, 5, 0), 6); // only one band declares it

  RelevoRaster alpha = MakePicture(8, 8, 4, {}, "");
  alpha.SetValues(
    [](int band, int column, int) { return band == 3 ? (column < 4 ? 0.0 : 255.0) : 50.0 + band; });
  CHECK(alpha.Write(folders.File("ImageryAlpha.png"), "PNG"));
  image = Drape(source, terrain, folders.File("ImageryAlpha.png"));
  CHECK_EQUAL(Color(image, 1, 4, 0), Grey);
  CHECK_EQUAL(Color(image, 1, 4, 1), Grey);
  CHECK_EQUAL(Color(image, 6, 4, 0), 50);
  CHECK_EQUAL(Color(image, 6, 4, 1), 51);

  RelevoRaster wide = MakePicture(8, 8, 3, utm, "EPSG:32633");
  wide.Type = GDT_UInt16;
  wide.SetValues([](int, int column, int) { return 1000.0 + 500.0 * column; });
  CHECK(wide.Write(folders.File("ImageryWide.tif")));
  image = Drape(source, terrain, folders.File("ImageryWide.tif"));
  CHECK_EQUAL(Color(image, 0, 0, 0), 0);
  CHECK_EQUAL(Color(image, 7, 0, 0), 255);
  CHECK_NEAR(Color(image, 3, 0, 1), 255.0 * 3.0 / 7.0, 1.0);

  // A palette is converted to colours.
  GDALDatasetH palette = GDALCreate(GDALGetDriverByName("GTiff"),
    folders.File("ImageryPalette.tif").c_str(), 8, 8, 1, GDT_Byte, nullptr);
  GDALSetGeoTransform(palette, const_cast<double*>(utm.data()));
  GDALColorTableH table = GDALCreateColorTable(GPI_RGB);
  const GDALColorEntry orange = { 250, 120, 10, 255 };
  GDALSetColorEntry(table, 3, &orange);
  GDALSetRasterColorTable(GDALGetRasterBand(palette, 1), table);
  GDALDestroyColorTable(table);
  CHECK_EQUAL(GDALFillRaster(GDALGetRasterBand(palette, 1), 3.0, 0.0), CE_None);
  GDALClose(palette);
  image = Drape(source, terrain, folders.File("ImageryPalette.tif"));
  CHECK_EQUAL(Color(image, 4, 4, 0), 250);
  CHECK_EQUAL(Color(image, 4, 4, 1), 120);
  CHECK_EQUAL(Color(image, 4, 4, 2), 10);
}

// Settings of the heights do not change the imagery.
void TestCache(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainSource> source;
  vtkImageData* image =
    Drape(source, folders.File("ImageryTerrain.tif"), folders.File("ImagerySix.tif"));
  const vtkMTimeType before = image->GetMTime();
  source->SetExaggeration(4.0);
  source->SetResolution(7);
  source->Update();
  CHECK_EQUAL(source->GetImagery(), image);
  CHECK_EQUAL(image->GetMTime(), before);
  source->SetImageryBands(1, 2, 3);
  source->Update();
  CHECK_GREATER(image->GetMTime(), before);
  source->SetImageryFileName(nullptr);
  source->Update();
  CHECK(source->GetImagery() == nullptr && source->GetOutput()->GetNumberOfCells() > 0);
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string terrain = folders.File("ImageryTerrain.tif");
  vtkNew<vtkTerrainSource> source;
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive()); // repeats every error
  const auto fails = [&](const std::string& picture, const std::string& reason)
  {
    vtkImageData* image = Drape(source, terrain, picture);
    CHECK(errors.Said(reason));
    CHECK_EQUAL(source->GetOutput()->GetNumberOfPoints(), 0);
    CHECK_EQUAL(image->GetNumberOfPoints(), 0);
  };
  fails(folders.File("no picture.tif"), "no picture.tif: the file does not exist");
  const std::string elsewhere = folders.File("ImageryElsewhere.tif");
  CHECK(MakePicture(8, 8, 3, { 700000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 }, "EPSG:32633")
          .Write(elsewhere));
  fails(elsewhere, "does not overlap the terrain");
  const std::string text = folders.File("ImageryText.jpg");
  std::ofstream(text) << "no picture";
  fails(text, "ImageryText.jpg");
  RelevoTruncate(folders.File("ImagerySix.tif"), folders.File("ImageryHalf.tif"), 0.5);
  fails(folders.File("ImageryHalf.tif"), "ImageryHalf.tif");
  Drape(source, terrain, folders.File("ImagerySix.tif"));
  CHECK(errors.None() && source->GetOutput()->GetNumberOfCells() > 0);
}

// Real pictures: every tenth pixel is compared with the file's pixels around the same longitude and
// latitude, or easting and northing.
void TestRealFile(RelevoCheck& check, const std::string& terrainName,
  const std::string& pictureName, const std::array<int, 3>& bands)
{
  vtkNew<vtkTerrainSource> source;
  source->SetImageryBands(bands[0], bands[1], bands[2]);
  vtkImageData* image = Drape(source, terrainName, pictureName);
  int dimensions[3];
  image->GetDimensions(dimensions);
  GDALDatasetH terrain = GDALOpen(terrainName.c_str(), GA_ReadOnly);
  GDALDatasetH picture = GDALOpen(pictureName.c_str(), GA_ReadOnly);
  double ground[6];
  double pixels[6];
  const bool located = GDALGetGeoTransform(terrain, ground) == CE_None &&
    GDALGetGeoTransform(picture, pixels) == CE_None;
  const int width = GDALGetRasterXSize(picture);
  const int height = GDALGetRasterYSize(picture);
  int different = 0;
  int compared = 0;
  for (int j = 5; j < dimensions[1]; j += 10)
  {
    for (int i = 5; i < dimensions[0]; i += 10)
    {
      const double u = (i + 0.5) / dimensions[0];
      const double v = (j + 0.5) / dimensions[1];
      double column = u * width;
      double row = (1.0 - v) * height;
      if (located)
      {
        const double x = ground[0] + ground[1] * u * GDALGetRasterXSize(terrain);
        const double y = ground[3] + ground[5] * (1.0 - v) * GDALGetRasterYSize(terrain);
        column = (x - pixels[0]) / pixels[1];
        row = (y - pixels[3]) / pixels[5];
      }
      const int west = static_cast<int>(std::floor(column - 0.5));
      const int north = static_cast<int>(std::floor(row - 0.5));
      if (west < 1 || north < 1 || west + 3 > width || north + 3 > height)
      {
        continue;
      }
      for (int c = 0; c < 3; ++c)
      {
        const int band = bands[c] ? bands[c] : c + 1;
        unsigned char around[16];
        if (GDALRasterIO(GDALGetRasterBand(picture, band), GF_Read, west - 1, north - 1, 4, 4,
              around, 4, 4, GDT_Byte, 0, 0) != CE_None)
        {
          ++different;
          continue;
        }
        const auto range = std::minmax_element(around, around + 16);
        const int color = Color(image, i, j, c);
        different += color < *range.first || color > *range.second;
        ++compared;
      }
    }
  }
  GDALClose(terrain);
  GDALClose(picture);
  std::cout << pictureName << ": " << dimensions[0] << " x " << dimensions[1] << ", " << compared
            << " compared\n";
  CHECK_GREATER(compared, 1000);
  CHECK_EQUAL(different, 0);
}
}

int TestTerrainSourceImagery(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestSameGrid(check, folders);
  TestOtherCoordinateSystem(check, folders);
  TestPixels(check, folders);
  TestCache(check, folders);
  TestErrors(check, folders);
  if (!folders.RealData.empty())
  {
    const std::string& data = folders.RealData;
    TestRealFile(check, data + "rmnp-dem.tif", data + "rmnp-rgb.tif", { 0, 0, 0 });
    TestRealFile(check, data + "olinda_dem_utm25s.tif", data + "L7_ETMs.tif", { 3, 2, 1 });
    TestRealFile(check, data + "earth-topology.png", data + "earth-blue-marble.jpg", { 0, 0, 0 });
  }
  return check.GetResult();
}

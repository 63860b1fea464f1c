// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Imagery is resampled to the lattices of a raster: positions, levels, kinds of images, and files
// that cannot be used. GDALWarp() and OGR's transformations are independent of the tiles.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "Imagery/OpenImagery.h"
#include "Lattice/HeightLattice.h"
#include "vtkMath.h"
#include "vtkTerrainPyramid.h"

#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <thread>

using relevo::ImageryLattice;
using relevo::ImageryTile;
using relevo::TerrainTile;

namespace
{
constexpr int Step = 5; // of the colours of MakeRamps() per pixel

// The red and green of a pixel are Step times its column and row.
RelevoRaster MakeRamps(int size, const std::vector<double>& transform, const std::string& system)
{
  RelevoRaster raster;
  raster.Width = size;
  raster.Height = size;
  raster.NumberOfBands = 3;
  raster.Type = GDT_Byte;
  raster.Transform = transform;
  raster.CoordinateSystem = system;
  raster.SetValues(
    [](int band, int column, int row) {
      return band == 0 ? Step * column : band == 1 ? Step * row : 77;
    });
  return raster;
}

// A raster of heights, as imagery sees it.
class ImageryTerrain
{
public:
  ImageryTerrain(RelevoCheck& check, const RelevoTestFolders& folders, int size,
    const std::vector<double>& transform, const std::string& system)
    : File(folders.File("TerrainImageryHeights.tif"))
  {
    CHECK(RelevoRaster::MakeSlope(size, size, transform, system).Write(this->File));
    this->Pyramid->SetFileName(this->File.c_str());
    CHECK(this->Pyramid->Update());
  }

  std::shared_ptr<const ImageryLattice> Open(const std::string& file)
  {
    relevo::ImageryOptions options;
    options.FileName = file;
    options.HasNumbers = this->HasNumbers;
    return relevo::OpenImagery(
      options, this->Pyramid->GetLattice()->Describe(), this->Warning, this->Error);
  }

  std::string File;
  vtkNew<vtkTerrainPyramid> Pyramid;
  bool HasNumbers = false;
  std::string Warning;
  std::string Error;
};

ImageryTile ReadTile(
  RelevoCheck& check, const ImageryLattice& imagery, int level, int column, int row)
{
  ImageryTile tile;
  tile.Level = level;
  tile.Column = column;
  tile.Row = row;
  std::string error;
  CHECK(imagery.Read(tile, error));
  CHECK_EQUAL(error, "");
  return tile;
}

// Imagery in UTM on a raster in degrees: the colours of all texels are those of their positions,
// within half a pixel of the imagery.
void TestPositions(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::array<double, 2> corner = { { 9.02, 45.03 } };
  constexpr double spacing = 0.0005; // about 39 m x 56 m
  constexpr int size = 300;
  ImageryTerrain terrain(
    check, folders, size, { corner[0], spacing, 0.0, corner[1], 0.0, -spacing }, "EPSG:4326");
  constexpr int pixels = 51;
  constexpr double pixel = 60.0;
  const std::array<double, 2> origin = { { 505000.0, 4984000.0 } };
  const std::string file = folders.File("TerrainImageryRamps.tif");
  CHECK(
    MakeRamps(pixels, { origin[0], pixel, 0.0, origin[1], 0.0, -pixel }, "EPSG:32632").Write(file));
  const auto imagery = terrain.Open(file);
  CHECK_EQUAL(terrain.Error + terrain.Warning, "");
  if (!imagery)
  {
    return;
  }
  CHECK_EQUAL(imagery->GetFinestLevel(), 0);
  CHECK(imagery->Covers(0, 0, 0));
  CHECK(!imagery->Covers(0, 1, 0));
  CHECK(!imagery->Covers(-1, 0, 2));

  OGRSpatialReferenceH degrees = OSRNewSpatialReference(nullptr);
  OGRSpatialReferenceH metres = OSRNewSpatialReference(nullptr);
  OSRSetFromUserInput(degrees, "EPSG:4326");
  OSRSetFromUserInput(metres, "EPSG:32632");
  OSRSetAxisMappingStrategy(degrees, OAMS_TRADITIONAL_GIS_ORDER);
  OSRSetAxisMappingStrategy(metres, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH conversion = OCTNewCoordinateTransformation(degrees, metres);
  for (int level : { -2, -1, 0, 1 })
  {
    CHECK_CASE(level);
    double largest = 0.0;
    int covered = 0;
    int wrong = 0;
    for (int tileNumber = 0; tileNumber < 4; ++tileNumber)
    {
      const ImageryTile tile = ReadTile(check, *imagery, level, tileNumber % 2, tileNumber / 2);
      for (int j = -1; j < TerrainTile::Stride - 1; ++j)
      {
        for (int i = -1; i < TerrainTile::Stride - 1; ++i)
        {
          const double samples = std::ldexp(1.0, level);
          double x = corner[0] + spacing * (0.5 + samples * (256.0 * tile.Column + i));
          double y = corner[1] - spacing * (0.5 + samples * (256.0 * tile.Row + j));
          OCTTransform(conversion, 1, &x, &y, nullptr);
          const double column = (x - origin[0]) / pixel - 0.5;
          const double row = (origin[1] - y) / pixel - 0.5;
          const unsigned char* color = tile.GetColor(i, j);
          // Texels of level 1 are larger than pixels.
          const double border = level > 0 ? 1.5 : 0.0;
          if (std::min(column, row) >= border && std::max(column, row) <= pixels - 1 - border)
          {
            largest = std::max({ largest, std::abs(color[0] / double(Step) - column),
              std::abs(color[1] / double(Step) - row) });
            wrong += color[2] != 77 || color[3] != 255 ? 1 : 0;
            ++covered;
          }
          else if (std::min(column, row) < -1.5 || std::max(column, row) > pixels + 0.5)
          {
            wrong += color[0] || color[1] || color[2] || color[3] ? 1 : 0;
          }
        }
      }
    }
    std::cout << "level " << level << ": " << covered << " texels, at most " << largest
              << " pixels away\n";
    CHECK_GREATER(covered, 500);
    CHECK_EQUAL(wrong, 0);
    CHECK_LESS(largest, 0.5);
  }
  OCTDestroyCoordinateTransformation(conversion);
  OSRDestroySpatialReference(degrees);
  OSRDestroySpatialReference(metres);
}

// The same texels as GDALWarp() makes for the grid of a tile.
void TestWarp(RelevoCheck& check, const RelevoTestFolders& folders)
{
  ImageryTerrain terrain(
    check, folders, 300, { 9.02, 0.0005, 0.0, 45.03, 0.0, -0.0005 }, "EPSG:4326");
  RelevoRaster raster = MakeRamps(500, { 503000.0, 7.0, 0.0, 4986000.0, 0.0, -7.0 }, "EPSG:32632");
  raster.SetValues([](int band, int column, int row)
    { return 128.0 + 100.0 * std::sin(column / 9.0 + band) * std::cos(row / 7.0); });
  const std::string file = folders.File("TerrainImageryWarp.tif");
  CHECK(raster.Write(file));
  const auto imagery = terrain.Open(file);
  CHECK_EQUAL(terrain.Error, "");
  if (!imagery)
  {
    return;
  }
  CHECK_EQUAL(imagery->GetFinestLevel(), -3);
  for (int level : { -3, -1, 0 })
  {
    CHECK_CASE(level);
    const int column = level < -1 ? 1 : 0;
    const double spacing = 0.0005 * std::ldexp(1.0, level);
    const double left = 9.02 + 0.0005 * 0.5 + spacing * (256.0 * column - 1.5);
    const double top = 45.03 - 0.0005 * 0.5 + spacing * 1.5;
    std::vector<std::string> arguments = { "-of", "MEM", "-t_srs", "EPSG:4326", "-r", "bilinear",
      "-et", "0", "-dstalpha", "-ovr", "NONE", "-ts", "259", "259", "-te" };
    // Metres per degree at 45 degrees north; the width of GDAL's filter otherwise depends on the
    // window.
    arguments.insert(arguments.begin(),
      { "-wo", "XSCALE=" + std::to_string(7.0 / (78846.0 * spacing)), "-wo",
        "YSCALE=" + std::to_string(7.0 / (111132.0 * spacing)) });
    for (double bound : { left, top - 259 * spacing, left + 259 * spacing, top })
    {
      std::ostringstream text;
      text.precision(17);
      text << bound;
      arguments.push_back(text.str());
    }
    char** list = nullptr;
    for (const std::string& argument : arguments)
    {
      list = CSLAddString(list, argument.c_str());
    }
    GDALWarpAppOptions* options = GDALWarpAppOptionsNew(list, nullptr);
    CSLDestroy(list);
    GDALDatasetH source = GDALOpen(file.c_str(), GA_ReadOnly);
    GDALDatasetH warped = GDALWarp("", nullptr, 1, &source, options, nullptr);
    GDALWarpAppOptionsFree(options);
    std::vector<unsigned char> expected(4 * TerrainTile::NumberOfVertices);
    CHECK(warped &&
      GDALDatasetRasterIO(warped, GF_Read, 0, 0, 259, 259, expected.data(), 259, 259, GDT_Byte, 4,
        nullptr, 4, 4 * 259, 1) == CE_None);
    GDALClose(warped);
    GDALClose(source);
    const ImageryTile tile = ReadTile(check, *imagery, level, column, 0);
    int different = 0;
    double largest = 0.0;
    int opaque = 0;
    for (std::size_t i = 0; i < expected.size(); i += 4)
    {
      opaque += expected[i + 3] == 255 ? 1 : 0;
      for (int j = 0; j < 4; ++j)
      {
        const double value = j == 3 ? expected[i + 3] : expected[i + j] * expected[i + 3] / 255.0;
        different += std::abs(tile.Colors[i + j] - value) > 2.0 ? 1 : 0;
        largest = std::max(largest, std::abs(tile.Colors[i + j] - value));
      }
    }
    std::cout << "level " << level << ": " << opaque << " texels, at most " << largest
              << " from GDALWarp()\n";
    CHECK_GREATER(opaque, 1000);
    CHECK_EQUAL(different, 0);
  }
}

// Images without colours, with fewer or more bands, and other types of samples.
void TestKinds(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ImageryTerrain terrain(check, folders, 40, utm, "EPSG:32633");
  const std::string file = folders.File("TerrainImageryKinds.tif");
  const auto read = [&](const RelevoRaster& raster)
  {
    CHECK(raster.Write(file));
    const auto imagery = terrain.Open(file);
    CHECK_EQUAL(terrain.Error + terrain.Warning, "");
    CHECK_EQUAL(imagery ? imagery->GetFinestLevel() : -99, 0);
    return imagery ? ReadTile(check, *imagery, 0, 0, 0) : ImageryTile();
  };
  const auto isColor = [](const ImageryTile& tile, int i, int j, std::array<int, 4> expected)
  { return std::equal(expected.begin(), expected.end(), tile.GetColor(i, j)); };
  RelevoRaster raster = MakeRamps(40, utm, "EPSG:32633");
  ImageryTile tile = read(raster);
  CHECK(isColor(tile, 3, 7, { { 15, 35, 77, 255 } }));
  CHECK(isColor(tile, 39, 39, { { 195, 195, 77, 255 } }));
  CHECK(isColor(tile, -1, 0, { { 0, 0, 0, 0 } }));
  CHECK(isColor(tile, 40, 0, { { 0, 0, 0, 0 } }));

  raster.NoData = 15.0; // in all bands
  raster.SetValues(
    [](int band, int column, int row) {
      return column == 3 && row == 7 ? 15 : column == 4 && band == 0 ? 15 : 100;
    });
  tile = read(raster);
  CHECK(isColor(tile, 3, 7, { { 0, 0, 0, 0 } }));
  CHECK(isColor(tile, 4, 7, { { 15, 100, 100, 255 } }));
  raster.NoData.reset();

  raster.NumberOfBands = 1;
  raster.SetValues([](int, int column, int row) { return column + row; });
  CHECK(isColor(read(raster), 3, 7, { { 10, 10, 10, 255 } }));

  // The fourth band is alpha; colours are multiplied by it.
  raster.NumberOfBands = 4;
  raster.Options = { "PHOTOMETRIC=RGB", "ALPHA=YES" };
  raster.SetValues(
    [](int band, int column, int) {
      return band < 3 ? 50 + 50 * band : column == 2 ? 0 : column == 3 ? 51 : 255;
    });
  tile = read(raster);
  CHECK(isColor(tile, 2, 0, { { 0, 0, 0, 0 } }));
  CHECK(isColor(tile, 3, 0, { { 10, 20, 30, 51 } }));
  CHECK(isColor(tile, 4, 0, { { 50, 100, 150, 255 } }));

  raster.Options.clear();
  raster.NumberOfBands = 3;
  raster.Type = GDT_UInt16;
  raster.SetValues([](int, int column, int) { return 1000.0 + 100.0 * column; });
  tile = read(raster);
  CHECK(isColor(tile, 0, 0, { { 0, 0, 0, 255 } }));
  CHECK(isColor(tile, 39, 0, { { 255, 255, 255, 255 } }));
  CHECK_NEAR(tile.GetColor(13, 5)[1], 255.0 / 3.0, 1.0);

  GDALDatasetH palette =
    GDALCreate(GDALGetDriverByName("GTiff"), file.c_str(), 40, 40, 1, GDT_Byte, nullptr);
  GDALSetGeoTransform(palette, const_cast<double*>(utm.data()));
  GDALColorTableH table = GDALCreateColorTable(GPI_RGB);
  const GDALColorEntry orange = { 250, 120, 10, 255 };
  GDALSetColorEntry(table, 3, &orange);
  GDALSetRasterColorTable(GDALGetRasterBand(palette, 1), table);
  GDALDestroyColorTable(table);
  CHECK_EQUAL(GDALFillRaster(GDALGetRasterBand(palette, 1), 3.0, 0.0), CE_None);
  GDALClose(palette);
  const auto imagery = terrain.Open(file);
  CHECK_EQUAL(terrain.Error, "");
  CHECK(imagery && isColor(ReadTile(check, *imagery, 0, 0, 0), 9, 9, { { 250, 120, 10, 255 } }));
}

// The numbers of a raster, with its scale, offset and missing data.
void TestNumbers(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ImageryTerrain terrain(check, folders, 40, utm, "EPSG:32633");
  terrain.HasNumbers = true;
  RelevoRaster raster = RelevoRaster::MakeSlope(40, 40, utm, "EPSG:32633");
  raster.Type = GDT_Int16;
  raster.NoData = -1.0;
  raster.Scale = 0.5;
  raster.Offset = 100.0;
  raster.SetValues([](int, int column, int row) { return column == 5 ? -1 : 10 * column + row; });
  const std::string file = folders.File("TerrainImageryNumbers.tif");
  CHECK(raster.Write(file));
  const auto imagery = terrain.Open(file);
  CHECK_EQUAL(terrain.Error + terrain.Warning, "");
  if (!imagery)
  {
    return;
  }
  CHECK(imagery->HasNumbers());
  CHECK_EQUAL(imagery->GetRange()[0], 100.0);
  CHECK_EQUAL(imagery->GetRange()[1], 100.0 + 0.5 * 429.0);
  const ImageryTile tile = ReadTile(check, *imagery, 0, 0, 0);
  CHECK(tile.Colors.empty());
  const auto get = [&tile](int i, int j)
  { return tile.Numbers[std::size_t(j + 1) * TerrainTile::Stride + i + 1]; };
  CHECK_EQUAL(get(3, 7), 100.0f + 0.5f * 37.0f);
  CHECK_EQUAL(get(39, 39), 100.0f + 0.5f * 429.0f);
  CHECK(std::isnan(get(5, 7)) && std::isnan(get(41, 0)));
}

// Coarse tiles are read from overviews, without aliasing.
void TestOverviews(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ImageryTerrain terrain(check, folders, 1024, utm, "EPSG:32633");
  RelevoRaster raster = MakeRamps(1024, utm, "EPSG:32633");
  raster.SetValues([](int, int column, int row) { return (column + row) % 2 * 200; });
  const std::string file = folders.File("TerrainImageryOverviews.tif");
  CHECK(raster.Write(file));
  auto imagery = terrain.Open(file);
  CHECK_EQUAL(terrain.Error, "");
  if (!imagery)
  {
    return;
  }
  // The mean of the pixels, without overviews.
  for (int level : { 2, 3 })
  {
    const auto tile = ReadTile(check, *imagery, level, 0, 0);
    const unsigned char* color = tile.GetColor(40, 40);
    CHECK_NEAR(color[0], 100, 13);
    CHECK_EQUAL(color[3], 255);
  }
  // Overviews with colours of their own.
  imagery.reset();
  GDALDatasetH dataset = GDALOpen(file.c_str(), GA_Update);
  int factors[] = { 2, 4 };
  CHECK_EQUAL(
    GDALBuildOverviews(dataset, "NEAREST", 2, factors, 0, nullptr, nullptr, nullptr), CE_None);
  for (int band = 1; band <= 3; ++band)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double color = i == 0 ? 60.0 : 90.0;
      CHECK_EQUAL(
        GDALFillRaster(GDALGetOverview(GDALGetRasterBand(dataset, band), i), color, 0.0), CE_None);
    }
  }
  GDALClose(dataset);
  imagery = terrain.Open(file);
  const std::array<int, 4> expected = { { -1, 60, 90, 90 } };
  for (int level = 0; level < 4; ++level)
  {
    CHECK_CASE(level);
    const ImageryTile tile = ReadTile(check, *imagery, level, 0, 0);
    const unsigned char* color = tile.GetColor(40, 40);
    CHECK_EQUAL(color[0], level == 0 ? 0 : expected[level]);
  }
  // So do those of a VRT.
  const std::string virtualFile = folders.File("TerrainImageryOverviews.vrt");
  dataset = GDALOpen(file.c_str(), GA_ReadOnly);
  GDALClose(GDALCreateCopy(
    GDALGetDriverByName("VRT"), virtualFile.c_str(), dataset, false, nullptr, nullptr, nullptr));
  GDALClose(dataset);
  imagery = terrain.Open(virtualFile);
  CHECK_EQUAL(terrain.Error, "");
  CHECK_EQUAL(ReadTile(check, *imagery, 1, 0, 0).GetColor(40, 40)[0], 60);
  CHECK_EQUAL(ReadTile(check, *imagery, 0, 0, 0).GetColor(40, 40)[0], 0);
  // Threads get the same tiles.
  const ImageryTile first = ReadTile(check, *imagery, 0, 1, 2);
  std::vector<std::thread> threads;
  std::array<ImageryTile, 8> tiles;
  std::array<std::string, 8> errors;
  for (std::size_t i = 0; i < tiles.size(); ++i)
  {
    tiles[i].Column = 1;
    tiles[i].Row = 2;
    threads.emplace_back([&, i] { imagery->Read(tiles[i], errors[i]); });
  }
  for (std::size_t i = 0; i < tiles.size(); ++i)
  {
    threads[i].join();
    CHECK_EQUAL(errors[i], "");
    CHECK(tiles[i].Colors == first.Colors);
  }
}

// A warning says that a large image needs overviews.
void TestMissingOverviews(RelevoCheck& check, const RelevoTestFolders& folders)
{
  std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ImageryTerrain terrain(check, folders, 40, utm, "EPSG:32633");
  const std::string file = folders.File("TerrainImageryLargest.tif");
  for (const int size : { 8000, 8001 })
  {
    CHECK_CASE(size);
    char** options = CSLAddString(nullptr, "SPARSE_OK=TRUE");
    options = CSLAddString(options, "COMPRESS=DEFLATE");
    GDALDatasetH dataset =
      GDALCreate(GDALGetDriverByName("GTiff"), file.c_str(), size, size, 1, GDT_Byte, options);
    CSLDestroy(options);
    GDALSetGeoTransform(dataset, utm.data());
    GDALClose(dataset);
    CHECK(terrain.Open(file) != nullptr);
    CHECK_EQUAL(terrain.Warning.find("gdaladdo") != std::string::npos, size > 8000);
  }
  GDALDatasetH dataset = GDALOpen(file.c_str(), GA_Update);
  int factor = 2;
  CHECK_EQUAL(
    GDALBuildOverviews(dataset, "NONE", 1, &factor, 0, nullptr, nullptr, nullptr), CE_None);
  GDALClose(dataset);
  CHECK(terrain.Open(file) != nullptr);
  CHECK_EQUAL(terrain.Warning, "");
}

// Imagery of the whole earth on a small raster, and a small image on a raster of the whole earth.
void TestExtents(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> world = { -180.0, 1.0, 0.0, 90.0, 0.0, -1.0 };
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  RelevoRaster raster = MakeRamps(51, utm, "EPSG:32633");
  const std::string small = folders.File("TerrainImagerySmall.tif");
  const std::string large = folders.File("TerrainImageryLarge.tif");
  CHECK(raster.Write(small));
  raster.Transform = world;
  raster.CoordinateSystem = "EPSG:4326";
  raster.Width = 360;
  raster.Height = 180;
  raster.SetValues([](int, int column, int row) { return column == 195 && row == 44 ? 99 : 10; });
  CHECK(raster.Write(large));
  {
    // UTM zone 33 at 500 km east is 15 degrees east, and 5000 km north is 45.15 degrees north.
    ImageryTerrain terrain(check, folders, 700, utm, "EPSG:32633");
    const auto imagery = terrain.Open(large);
    CHECK_EQUAL(terrain.Error, "");
    CHECK(imagery && imagery->GetFinestLevel() > 1);
    CHECK(imagery && imagery->Covers(0, 2, 2));
    CHECK_NEAR(ReadTile(check, *imagery, 0, 0, 0).GetColor(128, 128)[0], 10, 80);
    CHECK_EQUAL(ReadTile(check, *imagery, 0, 0, 0).GetColor(128, 128)[3], 255);
  }
  ImageryTerrain terrain(check, folders, 180, { 0.0, 1.0, 0.0, 90.0, 0.0, -1.0 }, "EPSG:4326");
  const auto imagery = terrain.Open(small);
  CHECK_EQUAL(terrain.Error, "");
  CHECK_EQUAL(imagery ? imagery->GetFinestLevel() : 0, TerrainTile::FinestLevel);
  if (!imagery)
  {
    return;
  }
  // The centre of the image, in vertices of the finest lattice.
  double geographic[2];
  const double center[2] = { 500255.0, 4999745.0 };
  vtkNew<vtkTerrainPyramid> picture;
  picture->SetFileName(small.c_str());
  CHECK(picture->Update());
  CHECK(picture->RasterToGeographic(center, geographic));
  const int x = static_cast<int>(std::lround((geographic[0] - 0.5) * 4096.0));
  const int y = static_cast<int>(std::lround((89.5 - geographic[1]) * 4096.0));
  CHECK(imagery->Covers(TerrainTile::FinestLevel, x / 256, y / 256));
  CHECK(!imagery->Covers(TerrainTile::FinestLevel, x / 256 + 2, y / 256));
  CHECK(imagery->Covers(0, 0, 0));
  const ImageryTile tile = ReadTile(check, *imagery, TerrainTile::FinestLevel, x / 256, y / 256);
  const unsigned char* color = tile.GetColor(x % 256, y % 256);
  // A texel is 19 m x 27 m.
  CHECK_NEAR(color[0] / double(Step), 25.0, 1.5);
  CHECK_NEAR(color[1] / double(Step), 25.0, 1.5);
  CHECK_EQUAL(color[3], 255);
  // The image is less than a texel of the coarsest tile.
  CHECK_LESS(ReadTile(check, *imagery, 0, 0, 0).GetColor(15, 44)[3], 10);
}

// An image whose red and green are the sine and the cosine of the longitude.
RelevoRaster MakeTurn(double left, double right, double pixel, const std::string& system)
{
  RelevoRaster raster;
  raster.Width = static_cast<int>(std::lround((right - left) / pixel));
  raster.Height = static_cast<int>(std::lround(180.0 / pixel));
  raster.NumberOfBands = 3;
  raster.Type = GDT_Byte;
  raster.Transform = { left, pixel, 0.0, 90.0, 0.0, -pixel };
  raster.CoordinateSystem = system;
  raster.SetValues(
    [=](int band, int column, int)
    {
      const double angle = vtkMath::RadiansFromDegrees(left + (column + 0.5) * pixel);
      return std::round(128.0 + 120.0 * (band == 0 ? std::sin(angle) : std::cos(angle)));
    });
  return raster;
}

// Longitudes of the raster and of the imagery start anywhere. There is no seam where those of the
// imagery start.
void TestTurns(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Case
  {
    std::string System;
    double Left; // of the raster
    double ImageryLeft;
    double ImageryRight;
  };
  constexpr double pixel = 4.0;
  const std::string degrees = "EPSG:4326";
  const std::string otherDatum = "EPSG:4284"; // Pulkovo 1942, less than 200 m away
  for (const Case& test :
    { Case{ degrees, -180.0, 0.0, 360.0 }, Case{ degrees, 0.0, -180.0, 180.0 },
      Case{ degrees, -180.0, -180.0, 180.0 }, Case{ degrees, -180.0, 160.0, 200.0 },
      Case{ degrees, 0.0, -20.0, 20.0 }, Case{ degrees, -180.0, 200.0, 240.0 },
      Case{ otherDatum, -180.0, 0.0, 360.0 }, Case{ otherDatum, 0.0, -180.0, 180.0 } })
  {
    CHECK_CASE(test.System + " " + std::to_string(test.Left) + ", " +
      std::to_string(test.ImageryLeft) + " to " + std::to_string(test.ImageryRight));
    ImageryTerrain terrain(check, folders, 360, { test.Left, 1.0, 0.0, 90.0, 0.0, -0.5 }, degrees);
    const std::string file = folders.File("TerrainImageryTurn.tif");
    CHECK(MakeTurn(test.ImageryLeft, test.ImageryRight, pixel, test.System).Write(file));
    const auto imagery = terrain.Open(file);
    CHECK_EQUAL(terrain.Error + terrain.Warning, "");
    if (!imagery)
    {
      continue;
    }
    CHECK_GREATER(imagery->GetFinestLevel(), 0);
    CHECK_LESS(imagery->GetFinestLevel(), 3);
    for (const int level : { 0, 1, 2 })
    {
      CHECK_CASE(level);
      double largest = 0.0;
      int missing = 0;
      int superfluous = 0;
      int covered = 0;
      for (int tileColumn = 0; tileColumn < (level == 0 ? 2 : 1); ++tileColumn)
      {
        const ImageryTile tile = ReadTile(check, *imagery, level, tileColumn, 0);
        const bool isUsed = imagery->Covers(level, tileColumn, 0);
        const int j = 180 >> level; // the equator
        for (int i = -1; i < TerrainTile::Stride - 1; ++i)
        {
          const double column = std::ldexp(256.0 * tileColumn + i, level);
          if (column > 361.0)
          {
            break; // not drawn
          }
          const double longitude = test.Left + column + 0.5;
          const double center = 0.5 * (test.ImageryLeft + test.ImageryRight);
          const double beside =
            std::abs(longitude - center - 360.0 * std::round((longitude - center) / 360.0));
          const double half = 0.5 * (test.ImageryRight - test.ImageryLeft);
          const unsigned char* color = tile.GetColor(i, j);
          if (beside > half + pixel)
          {
            superfluous += color[3] != 0 ? 1 : 0;
          }
          else if (half >= 180.0 || beside < half - pixel)
          {
            ++covered;
            missing += color[3] < 255 || !isUsed ? 1 : 0;
            const double angle =
              vtkMath::DegreesFromRadians(std::atan2(color[0] - 128.0, color[1] - 128.0));
            const double distance = longitude - angle;
            largest =
              std::max(largest, std::abs(distance - 360.0 * std::round(distance / 360.0)) / pixel);
          }
        }
      }
      std::cout << "level " << level << ": " << covered << " texels, at most " << largest
                << " pixels away\n";
      CHECK_GREATER(covered, 5);
      CHECK_EQUAL(missing, 0);
      CHECK_EQUAL(superfluous, 0);
      CHECK_LESS(largest, 0.5);
    }
  }
}

// Imagery that changes while it is open is not read further, so that old and new pixels never mix.
void TestReplaced(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ImageryTerrain terrain(check, folders, 40, utm, "EPSG:32633");
  const std::string file = folders.File("TerrainImageryReplaced.tif");
  CHECK(MakeRamps(51, utm, "EPSG:32633").Write(file));
  const auto imagery = terrain.Open(file);
  if (!CHECK(imagery != nullptr))
  {
    return;
  }
  ReadTile(check, *imagery, 0, 0, 0);
  const std::string other = folders.File("TerrainImageryOther.tif");
  CHECK(MakeRamps(50, utm, "EPSG:32633").Write(other));
  std::filesystem::rename(other, file);
  ImageryTile tile;
  std::string error;
  CHECK(!imagery->Read(tile, error));
  CHECK(error.find("has changed since it was opened") != std::string::npos);
  const auto again = terrain.Open(file);
  CHECK(again != nullptr);
  ReadTile(check, *again, 0, 0, 0);
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> utm = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ImageryTerrain terrain(check, folders, 40, utm, "EPSG:32633");
  const auto fails = [&](const std::string& file, const std::string& reason)
  {
    CHECK(terrain.Open(file) == nullptr);
    std::cout << file << ": " << terrain.Error << "\n";
    CHECK(terrain.Error.find(reason) != std::string::npos);
    CHECK_EQUAL(terrain.Warning, "");
  };
  fails(folders.File("no picture.tif"), "does not exist");
  const std::string text = folders.File("TerrainImageryText.jpg");
  std::ofstream(text) << "no picture";
  fails(text, "not");
  const std::string file = folders.File("TerrainImageryElsewhere.tif");
  CHECK(MakeRamps(51, { 700000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 }, "EPSG:32633").Write(file));
  fails(file, "does not overlap the terrain");
  CHECK(MakeRamps(51, utm, "EPSG:32633").Write(file));
  const std::string half = folders.File("TerrainImageryHalf.tif");
  RelevoTruncate(file, half, 0.5);
  fails(half, "truncated");

  // An image without a georeference covers the whole raster, half a sample around it too.
  CHECK(MakeRamps(51, {}, "").Write(file));
  const auto imagery = terrain.Open(file);
  CHECK_EQUAL(terrain.Error, "");
  CHECK(terrain.Warning.find("no georeference") != std::string::npos);
  CHECK_EQUAL(imagery ? imagery->GetFinestLevel() : -99, -1);
  for (int i : { 0, 20, 39 })
  {
    const ImageryTile tile = ReadTile(check, *imagery, 0, 0, 0);
    CHECK_NEAR(tile.GetColor(i, 3)[0] / double(Step), (i + 0.5) * 51.0 / 40.0 - 0.5, 0.5);
    CHECK_NEAR(tile.GetColor(3, i)[1] / double(Step), (i + 0.5) * 51.0 / 40.0 - 0.5, 0.5);
  }
  // Neither has one.
  ImageryTerrain plain(check, folders, 40, {}, "");
  CHECK(plain.Open(file) != nullptr);
  CHECK_EQUAL(plain.Error + plain.Warning, "");
}
}

int TestTerrainImagery(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestPositions(check, folders);
  TestWarp(check, folders);
  TestKinds(check, folders);
  TestNumbers(check, folders);
  TestOverviews(check, folders);
  TestMissingOverviews(check, folders);
  TestExtents(check, folders);
  TestTurns(check, folders);
  TestReplaced(check, folders);
  TestErrors(check, folders);
  return check.GetResult();
}

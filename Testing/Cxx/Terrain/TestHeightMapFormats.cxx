// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightMap promises the samples of every format unchanged, compared bit for bit with the values
// written and with GDAL.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkHeightMap.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <limits>

namespace
{
// Whether samples with data are equal. The file's last row comes first.
bool SameSamples(vtkHeightMap* map, const RelevoRaster& raster)
{
  const int* dimensions = map->GetDimensions();
  if (dimensions[0] != raster.Width || dimensions[1] != raster.Height)
  {
    return false;
  }
  for (int row = 0; row < raster.Height; ++row)
  {
    for (int column = 0; column < raster.Width; ++column)
    {
      const std::size_t index =
        static_cast<std::size_t>(raster.Height - 1 - row) * raster.Width + column;
      const bool valid = !map->GetValidity() || map->GetValidity()[index];
      if (valid && map->GetSamples()[index] != static_cast<float>(raster.At(0, column, row)))
      {
        std::cerr << "column " << column << ", row " << row << ": " << map->GetSamples()[index]
                  << ", expected " << raster.At(0, column, row) << "\n";
        return false;
      }
    }
  }
  return true;
}

// A wrong type, sign, byte order or normalization would change these values.
void SetTypicalValues(RelevoRaster& raster)
{
  const bool isSigned = raster.Type != GDT_Byte && raster.Type != GDT_UInt16;
  const bool isReal = raster.Type == GDT_Float32 || raster.Type == GDT_Float64;
  const double largest = raster.Type == GDT_Byte ? 255.0
    : raster.Type == GDT_UInt16                  ? 65535.0
    : raster.Type == GDT_Int16                   ? 32767.0
                                                 : 1.0e6;
  const double lowest = isSigned ? -largest : 0.0;
  raster.SetValues(
    [&](int, int column, int row)
    {
      const double t = ((column * 31 + row * 17) % 101) / 100.0;
      const double value = lowest + t * (largest - lowest);
      return isReal ? value + 0.3125 : std::floor(value);
    });
}

void TestGeoTIFF(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (GDALDataType type : { GDT_Byte, GDT_UInt16, GDT_Int16, GDT_Int32, GDT_Float32, GDT_Float64 })
  {
    for (const char* compression : { "NONE", "LZW", "DEFLATE" })
    {
      for (bool tiled : { false, true })
      {
        RelevoRaster raster;
        raster.Width = 75; // neither one tile nor a multiple of a tile
        raster.Height = 133;
        raster.Type = type;
        raster.Options = { std::string("COMPRESS=") + compression,
          std::string("TILED=") + (tiled ? "YES" : "NO") };
        if (tiled)
        {
          raster.Options.insert(raster.Options.end(), { "BLOCKXSIZE=32", "BLOCKYSIZE=16" });
        }
        SetTypicalValues(raster);
        const std::string name = folders.File("HeightMapFormats.tif");
        CHECK(raster.Write(name));
        vtkNew<vtkHeightMap> map;
        map->SetFileName(name.c_str());
        if (!CHECK(map->Update()) || !CHECK(SameSamples(map, raster)))
        {
          std::cerr << "  for " << GDALGetDataTypeName(type) << " " << compression
                    << (tiled ? " tiled\n" : " striped\n");
        }
        CHECK(!map->HasNoData());
        const auto range = std::minmax_element(raster.Values.begin(), raster.Values.end());
        CHECK_EQUAL(map->GetRange()[0], static_cast<float>(*range.first));
        CHECK_EQUAL(map->GetRange()[1], static_cast<float>(*range.second));
      }
    }
  }
}

// Unusual layouts: odd numbers of bits, predictors, BigTIFF, and the first of several bands.
void TestUnusualGeoTIFF(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Case
  {
    GDALDataType Type;
    int NumberOfBands;
    double Largest;
    std::vector<std::string> Options;
  };
  const Case cases[] = {
    { GDT_UInt16, 1, 4095.0, { "NBITS=12" } },
    { GDT_Byte, 1, 15.0, { "NBITS=4" } },
    { GDT_Byte, 1, 1.0, { "NBITS=1" } },
    { GDT_Int16, 1, 30000.0, { "COMPRESS=LZW", "PREDICTOR=2", "BIGTIFF=YES" } },
    { GDT_Float32, 1, 30000.0, { "COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES" } },
    { GDT_Int16, 3, 30000.0, { "INTERLEAVE=PIXEL" } },
    { GDT_Int16, 3, 30000.0, { "INTERLEAVE=BAND", "TILED=YES" } },
    { GDT_Byte, 1, 255.0, { "PHOTOMETRIC=MINISWHITE" } },
    { GDT_UInt16, 1, 65535.0, { "ENDIANNESS=BIG" } },
  };
  for (const Case& one : cases)
  {
    RelevoRaster raster;
    raster.Width = 70;
    raster.Height = 45;
    raster.Type = one.Type;
    raster.NumberOfBands = one.NumberOfBands;
    raster.Options = one.Options;
    raster.SetValues([&](int band, int column, int row)
      { return std::floor(((column * 31 + row * 17 + band * 7) % 101) / 100.0 * one.Largest); });
    const std::string name = folders.File("HeightMapUnusual.tif");
    CHECK(raster.Write(name));
    vtkNew<vtkHeightMap> map;
    map->SetFileName(name.c_str());
    if (!CHECK(map->Update() && SameSamples(map, raster)))
    {
      std::cerr << "  for " << one.Options.front() << "\n";
    }
  }
}

// Blocks that were never written have the value 0 or the no-data value.
void TestSparseGeoTIFF(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 64;
  raster.Height = 64;
  raster.Type = GDT_Int16;
  raster.Options = { "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", "SPARSE_OK=TRUE" };
  raster.SetValues([](int, int column, int row) { return column < 16 && row < 16 ? 7 : 0; });
  const std::string name = folders.File("HeightMapSparse.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  CHECK(map->Update() && SameSamples(map, raster));
}

void TestPNG(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (GDALDataType type : { GDT_Byte, GDT_UInt16 })
  {
    RelevoRaster raster;
    raster.Width = 41;
    raster.Height = 23;
    raster.Type = type;
    SetTypicalValues(raster);
    const std::string name = folders.File("HeightMapFormats.png");
    CHECK(raster.Write(name, "PNG"));
    vtkNew<vtkHeightMap> map;
    map->SetFileName(name.c_str());
    CHECK(map->Update() && SameSamples(map, raster));
  }
}

void TestEXR(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (OIIO::TypeDesc type :
    { OIIO::TypeDesc(OIIO::TypeDesc::HALF), OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) })
  {
    for (int tile : { 0, 16 })
    {
      CHECK_CASE(tile);
      RelevoRaster raster;
      raster.Width = 50;
      raster.Height = 34;
      raster.SetValues([](int, int column, int row) { return column - 8.0 * row + 0.5; });
      const std::vector<float> values(raster.Values.begin(), raster.Values.end());
      OIIO::ImageSpec spec(raster.Width, raster.Height, 1, type);
      spec.tile_width = tile;
      spec.tile_height = tile;
      const std::string name = folders.File("HeightMapFormats.exr");
      auto output = OIIO::ImageOutput::create(name);
      CHECK(output && output->open(name, spec) &&
        output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
      vtkNew<vtkHeightMap> map;
      map->SetFileName(name.c_str());
      CHECK(map->Update() && SameSamples(map, raster));
    }
  }
}

// Writes the format by its definition: 1201 x 1201 big-endian int16, north first, -32768 for
// missing heights.
void TestHGT(RelevoCheck& check, const RelevoTestFolders& folders)
{
  constexpr int size = 1201;
  RelevoRaster raster;
  raster.Width = size;
  raster.Height = size;
  raster.SetValues([](int, int column, int row) { return (column * 7 + row * 13) % 4000 - 300; });
  raster.Values[5 * size + 3] = -32768.0;
  std::vector<char> bytes;
  for (double value : raster.Values)
  {
    const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(value));
    bytes.push_back(static_cast<char>(bits >> 8));
    bytes.push_back(static_cast<char>(bits & 255));
  }
  const std::string name = folders.File("N57E011.hgt");
  std::ofstream(name, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  CHECK(map->Update());
  CHECK(map->HasNoData() && map->GetNoDataValue() == -32768.0);
  const std::size_t hole = static_cast<std::size_t>(size - 1 - 5) * size + 3;
  CHECK(map->GetValidity() && !map->GetValidity()[hole]);
  CHECK_EQUAL(std::count(map->GetValidity(), map->GetValidity() + size * size, 0), 1);
  raster.Values[5 * size + 3] = map->GetSamples()[hole];
  CHECK(SameSamples(map, raster));
}

void TestUSGSDEM(RelevoCheck& check, const RelevoTestFolders& folders)
{
  GDALDriverH driver = GDALGetDriverByName("USGSDEM");
  if (!driver || !GDALGetMetadataItem(driver, GDAL_DCAP_CREATECOPY, nullptr))
  {
    std::cout << "This GDAL does not write USGS DEM: not tested.\n";
    return;
  }
  RelevoRaster raster;
  raster.Width = 30;
  raster.Height = 40;
  raster.Type = GDT_Int16;
  raster.Transform = { 500000.0, 30.0, 0.0, 5000000.0, 0.0, -30.0 };
  raster.CoordinateSystem = "EPSG:26710";
  raster.SetValues([](int, int column, int row) { return 100 + column * 3 + row; });
  const std::string name = folders.File("HeightMapFormats.dem");
  CHECK(raster.Write(name, "USGSDEM"));
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  CHECK(map->Update() && SameSamples(map, RelevoRaster::Read(name)));
  CHECK(map->GetRange()[0] == 100.0 && map->GetRange()[1] == 226.0);
}

// Heights include the file's scale and offset.
void TestScaleAndOffset(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 4;
  raster.Height = 3;
  raster.Type = GDT_Int16;
  raster.Scale = 0.25;
  raster.Offset = -10.0;
  raster.NoData = 5.0;
  raster.SetValues([](int, int column, int row) { return column + 4 * row; });
  const std::string name = folders.File("HeightMapScale.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  CHECK(map->Update());
  CHECK_EQUAL(map->GetSample(0, 2), -10.0);
  CHECK_EQUAL(map->GetSample(3, 0), 11 * 0.25 - 10.0);
  CHECK(map->HasNoData() && !map->GetValidity()[1 * 4 + 1]); // 5 as stored
}

// u runs east and v north for every layout of the file.
void TestOrientation(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const auto heightAt = [](double x, double y) { return 100.0 * x + y; };
  for (double dx : { 1.0, -1.0 })
  {
    CHECK_CASE(dx);
    for (double dy : { 1.0, -1.0 })
    {
      CHECK_CASE(dy);
      RelevoRaster raster;
      raster.Width = 5;
      raster.Height = 3;
      raster.Transform = { dx > 0.0 ? 0.0 : 5.0, dx, 0.0, dy > 0.0 ? 0.0 : 3.0, 0.0, dy };
      raster.SetValues(
        [&](int, int column, int row)
        {
          return heightAt(
            raster.Transform[0] + dx * (column + 0.5), raster.Transform[3] + dy * (row + 0.5));
        });
      const std::string name = folders.File("HeightMapOrientation.tif");
      CHECK(raster.Write(name));
      vtkNew<vtkHeightMap> map;
      map->SetFileName(name.c_str());
      for (int j = 0; j < 3; ++j)
      {
        for (int i = 0; i < 5; ++i)
        {
          CHECK_EQUAL(map->GetSample(i, j), heightAt(i + 0.5, j + 0.5));
        }
      }
    }
  }
}

// Rasters of one row, one column or one sample work.
void TestThinRasters(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (const auto& size : { std::pair<int, int>{ 1, 1 }, { 1, 9 }, { 9, 1 } })
  {
    RelevoRaster raster;
    raster.Width = size.first;
    raster.Height = size.second;
    raster.SetValues([](int, int column, int row) { return 3.0 + column + 2.0 * row; });
    const std::string name = folders.File("HeightMapThin.tif");
    CHECK(raster.Write(name));
    vtkNew<vtkHeightMap> map;
    map->SetFileName(name.c_str());
    CHECK(map->Update() && SameSamples(map, raster));
    CHECK_NEAR(map->GetHeight(0.0, 1.0), 3.0, 1e-6);
    CHECK_NEAR(map->GetHeight(1.0, 0.0), raster.Values.back(), 1e-6);
  }
}
}

int TestHeightMapFormats(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestGeoTIFF(check, folders);
  TestUnusualGeoTIFF(check, folders);
  TestSparseGeoTIFF(check, folders);
  TestPNG(check, folders);
  TestEXR(check, folders);
  TestHGT(check, folders);
  TestUSGSDEM(check, folders);
  TestScaleAndOffset(check, folders);
  TestOrientation(check, folders);
  TestThinRasters(check, folders);
  return check.GetResult();
}

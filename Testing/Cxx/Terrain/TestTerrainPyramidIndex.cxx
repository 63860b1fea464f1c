// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainPyramid promises the largest vertical distance between a level and full resolution, and
// an index file that is small, used again, and rebuilt if it is damaged or the raster has changed.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoSanitizer.h"

#include "Lattice/BlockErrors.h"
#include "Pyramid/PyramidIndex.h"
#include "vtkNew.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
namespace fs = std::filesystem;

constexpr std::size_t NumberOfDamages = RelevoHasAddressSanitizer ? 4 : 24;

// One level as the test reads it with GDAL.
struct Level
{
  int Width;
  int Height;
  std::vector<double> Values;

  // At u and v in samples of this level.
  double Interpolate(double u, double v) const
  {
    const double x = std::clamp(u, 0.0, this->Width - 1.0);
    const double y = std::clamp(v, 0.0, this->Height - 1.0);
    const int i = std::min(static_cast<int>(x), std::max(0, this->Width - 2));
    const int j = std::min(static_cast<int>(y), std::max(0, this->Height - 2));
    const auto at = [this](int column, int row)
    {
      return this->Values[static_cast<std::size_t>(std::min(row, this->Height - 1)) * this->Width +
        std::min(column, this->Width - 1)];
    };
    const double a = x - i;
    const double b = y - j;
    double sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double weight = (corner % 2 ? a : 1.0 - a) * (corner / 2 ? b : 1.0 - b);
      sum += weight > 0.0 ? weight * at(i + corner % 2, j + corner / 2) : 0.0;
    }
    return sum;
  }
};

std::vector<Level> ReadLevels(const std::string& name)
{
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_ReadOnly);
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  int hasNoData = 0;
  const double noData = GDALGetRasterNoDataValue(band, &hasNoData);
  std::vector<Level> levels;
  for (int i = -1; i < GDALGetOverviewCount(band); ++i)
  {
    GDALRasterBandH one = i < 0 ? band : GDALGetOverview(band, i);
    Level level{ GDALGetRasterBandXSize(one), GDALGetRasterBandYSize(one), {} };
    level.Values.resize(static_cast<std::size_t>(level.Width) * level.Height);
    if (GDALRasterIO(one, GF_Read, 0, 0, level.Width, level.Height, level.Values.data(),
          level.Width, level.Height, GDT_Float64, 0, 0) == CE_None &&
      hasNoData)
    {
      std::replace(
        level.Values.begin(), level.Values.end(), noData, std::numeric_limits<double>::quiet_NaN());
    }
    levels.push_back(level);
  }
  GDALClose(dataset);
  return levels;
}

// The largest deviation at a grid of points that is much denser than the samples.
double SampleDeviation(const Level& fine, const Level& coarse)
{
  constexpr int steps = 6;
  double largest = 0.0;
  for (int row = 0; row <= (fine.Height - 1) * steps; ++row)
  {
    const double y = static_cast<double>(row) / steps;
    const double v = (y + 0.5) * coarse.Height / fine.Height - 0.5;
    for (int column = 0; column <= (fine.Width - 1) * steps; ++column)
    {
      const double x = static_cast<double>(column) / steps;
      const double u = (x + 0.5) * coarse.Width / fine.Width - 0.5;
      const double d = std::abs(fine.Interpolate(x, y) - coarse.Interpolate(u, v));
      largest = d > largest ? d : largest;
    }
  }
  return largest;
}

bool BuildOverviews(const std::string& name, const char* resampling, std::vector<int> factors)
{
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_Update);
  const bool isBuilt = dataset &&
    GDALBuildOverviews(dataset, resampling, static_cast<int>(factors.size()), factors.data(), 0,
      nullptr, nullptr, nullptr) == CE_None;
  GDALClose(dataset);
  return isBuilt;
}

RelevoRaster MakeRough(int width, int height, GDALDataType type)
{
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Type = type;
  raster.Options = { "TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64" };
  std::mt19937 random(3);
  std::uniform_int_distribution<int> noise(-40, 40);
  raster.SetValues(
    [&](int, int column, int row) {
      return std::floor(900.0 * std::sin(0.013 * column) * std::cos(0.011 * row)) + noise(random);
    });
  return raster;
}

void RemoveIndex(const std::string& name)
{
  fs::remove(name + ".relevo-index");
}

// Odd sizes, holes, several resamplings, and strips: the error is that of the worst point.
void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Case
  {
    const char* Name;
    int Width;
    int Height;
    GDALDataType Type;
    const char* Resampling;
    bool HasHoles;
    bool IsTiled;
  };
  const Case cases[] = {
    { "average", 515, 387, GDT_Int16, "AVERAGE", false, true },
    { "nearest", 300, 401, GDT_Float32, "NEAREST", false, true },
    { "holes", 411, 300, GDT_Int16, "AVERAGE", true, true },
    { "strips", 1100, 130, GDT_Int16, "AVERAGE", true, false },
    { "sparse", 500, 460, GDT_Int16, "AVERAGE", false, true },
    { "one column", 1, 200, GDT_Int16, "AVERAGE", false, false },
  };
  for (const Case& one : cases)
  {
    CHECK_CASE(one.Name);
    RelevoRaster raster = MakeRough(one.Width, one.Height, one.Type);
    if (!one.IsTiled)
    {
      raster.Options.clear();
    }
    if (std::string(one.Name) == "sparse") // blocks of zeros are not stored
    {
      raster.Options.emplace_back("SPARSE_OK=TRUE");
      for (std::size_t i = 0; i < raster.Values.size(); ++i)
      {
        const std::size_t column = i % 500;
        const bool isStored = column > 137 && column < 250 && i / 500 > 180 && i / 500 < 260;
        raster.Values[i] = isStored ? raster.Values[i] + 2000.0 : 0.0;
      }
    }
    if (one.HasHoles)
    {
      raster.NoData = -32768.0;
      for (std::size_t i = 0; i < raster.Values.size(); ++i)
      {
        raster.Values[i] = i / 50 % 7 == 0 ? -32768.0 : raster.Values[i];
      }
    }
    const std::string name = folders.File("TerrainPyramidIndex.tif");
    RemoveIndex(name);
    CHECK(raster.Write(name));
    CHECK(BuildOverviews(name, one.Resampling, { 2, 4, 8 }));
    vtkNew<vtkTerrainPyramid> pyramid;
    RelevoErrors errors(pyramid);
    pyramid->SetFileName(name.c_str());
    CHECK(pyramid->Update());
    CHECK(pyramid->WaitForIndex());
    CHECK(pyramid->IsErrorKnown());
    const std::vector<Level> levels = ReadLevels(name);
    CHECK_EQUAL(pyramid->GetNumberOfLevels(), static_cast<int>(levels.size()));
    CHECK_EQUAL(pyramid->GetMaximumError(0), 0.0);
    for (int level = 1; level < pyramid->GetNumberOfLevels(); ++level)
    {
      CHECK_CASE(level);
      const double sampled = SampleDeviation(levels[0], levels[level]);
      const double error = pyramid->GetMaximumError(level);
      CHECK_LESS_EQUAL(sampled, error * (1.0 + 1e-9));
      CHECK_GREATER(sampled, 0.9 * error);
    }
    double range[2];
    pyramid->GetRange(range);
    const auto isLess = [](double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; };
    const std::vector<double>& values = levels[0].Values;
    CHECK_EQUAL(range[0], *std::min_element(values.begin(), values.end(), isLess));
    double highest = -1e9;
    for (double value : values)
    {
      highest = value > highest ? value : highest;
    }
    CHECK_EQUAL(range[1], highest);
    CHECK(errors.None());
  }
}

std::string ReadBytes(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

void WriteBytes(const std::string& name, const std::string& bytes)
{
  std::ofstream(name, std::ios::binary) << bytes;
}

// The file is small and used again; it is rebuilt when it is damaged or of another raster.
void TestFile(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRough(1030, 700, GDT_Int16);
  const std::string name = folders.File("TerrainPyramidFile.tif");
  const std::string indexName = name + ".relevo-index";
  RemoveIndex(name);
  CHECK(raster.Write(name));
  CHECK(BuildOverviews(name, "AVERAGE", { 2, 4 }));
  const std::string before = ReadBytes(name);
  const auto getError = [&](bool isComplete)
  {
    vtkNew<vtkTerrainPyramid> pyramid;
    RelevoErrors errors(pyramid);
    pyramid->SetFileName(name.c_str());
    CHECK(pyramid->Update());
    if (isComplete)
    {
      CHECK(pyramid->IsErrorKnown());
    }
    CHECK(pyramid->WaitForIndex());
    CHECK(errors.None());
    return pyramid->GetMaximumError(1);
  };
  const double error = getError(false);
  CHECK_GREATER(error, 10.0);
  CHECK(ReadBytes(name) == before); // the raster is never written to
  const std::string index = ReadBytes(indexName);
  CHECK_GREATER(index.size(), 100u);
  CHECK_LESS(index.size(), 0.02 * raster.Values.size() * 2);
  CHECK_EQUAL(getError(true), error);

  for (std::size_t i = 0; i < index.size(); i += 1 + index.size() / NumberOfDamages)
  {
    CHECK_CASE(i);
    std::string damaged = index;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x20);
    WriteBytes(indexName, damaged);
    CHECK_EQUAL(getError(false), error);
    CHECK(ReadBytes(indexName) == index);
    WriteBytes(indexName, index.substr(0, i));
    CHECK_EQUAL(getError(false), error);
  }

  // Another raster of the same size has the same name.
  for (double& value : raster.Values)
  {
    value *= 2.0;
  }
  CHECK(raster.Write(name));
  CHECK(BuildOverviews(name, "AVERAGE", { 2, 4 }));
  CHECK_NEAR(getError(false), 2.0 * error, 3.0);
}

// The index goes to the requested folder, which is created if necessary.
void TestCacheDirectory(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("TerrainPyramidCached.tif");
  const std::string folder = folders.File("TerrainPyramidCache/deep");
  fs::remove_all(folder);
  RemoveIndex(name);
  CHECK(MakeRough(300, 300, GDT_Int16).Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  pyramid->SetCacheDirectory(folder.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK(!fs::exists(name + ".relevo-index"));
  CHECK_EQUAL(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

// A file with a valid checksum may still have tiles outside of the raster, or NaN.
void TestInvalidNumbers(RelevoCheck& check, const RelevoTestFolders& folders)
{
  using relevo::PyramidIndex;
  const std::string name = folders.File("TerrainPyramidInvalid.relevo-index");
  using Sizes = std::vector<std::array<int, 2>>;
  const auto isRead = [&](int column, int row, float largestError)
  {
    PyramidIndex written(Sizes{ { { 1 << 20, 1 << 20 } } });
    written.AddAbsent(3.0);
    written.AddRange(0, column, row, 0.0, 9.0);
    auto errors = std::make_shared<relevo::BlockErrors>(1);
    errors->SetLargest(largestError);
    written.SetBlockErrors(errors);
    CHECK_EQUAL(written.Write(name, "signature"), std::string());
    PyramidIndex read(Sizes{ { { 1000, 700 } } });
    return read.Read(name, "signature");
  };
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(isRead(3, 2, 1.0f));
  CHECK(!isRead(4, 2, 1.0f));
  CHECK(!isRead(3, 3, 1.0f));
  CHECK(!isRead(3, 2, nan));
  CHECK(!isRead(3, 2, -1.0f));
}

// Of a large raster only few tiles are stored, and so is its index.
void TestSparse(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (const bool hasNoData : { true, false })
  {
    CHECK_CASE(hasNoData);
    const std::string name = folders.File("TerrainPyramidSparse.tif");
    RemoveIndex(name);
    fs::remove(name);
    constexpr int size = 1 << 16;
    char** options = nullptr;
    for (const char* option :
      { "TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=YES", "BLOCKXSIZE=512", "BLOCKYSIZE=512" })
    {
      options = CSLAddString(options, option);
    }
    GDALDatasetH dataset =
      GDALCreate(GDALGetDriverByName("GTiff"), name.c_str(), size, size, 1, GDT_Int16, options);
    CSLDestroy(options);
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    if (hasNoData)
    {
      GDALSetRasterNoDataValue(band, -32768.0);
    }
    std::vector<short> block(512 * 512);
    for (std::size_t i = 0; i < block.size(); ++i)
    {
      block[i] = static_cast<short>(100 + i % 512);
    }
    CHECK(GDALRasterIO(band, GF_Write, 40960, 20480, 512, 512, block.data(), 512, 512, GDT_Int16, 0,
            0) == CE_None);
    GDALClose(dataset);
    vtkNew<vtkTerrainPyramid> pyramid;
    RelevoErrors errors(pyramid);
    pyramid->SetFileName(name.c_str());
    CHECK(pyramid->Update());
    CHECK(pyramid->WaitForIndex());
    double range[2];
    pyramid->GetRange(range);
    CHECK_EQUAL(range[0], hasNoData ? 100.0 : 0.0);
    CHECK_EQUAL(range[1], 611.0);
    CHECK_LESS(fs::file_size(name + ".relevo-index"), 10000u);
    const double y = size - 20480 - 0.5;
    CHECK_EQUAL(pyramid->GetElevation(40960.5, y), 100.0);
    const double outside = pyramid->GetElevation(0.5, 0.5);
    CHECK(hasNoData ? std::isnan(outside) : outside == 0.0);
    CHECK(errors.None());
    fs::remove(name);
  }
}
}

int TestTerrainPyramidIndex(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestErrors(check, folders);
  TestFile(check, folders);
  TestCacheDirectory(check, folders);
  TestInvalidNumbers(check, folders);
  TestSparse(check, folders);
  return check.GetResult();
}

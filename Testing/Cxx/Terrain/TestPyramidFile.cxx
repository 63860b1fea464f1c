// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a raster and its overviews that GDAL caches take little memory, for one thread and
// for several, and none once the datasets are closed or if threads share the blocks. Many threads
// read the samples that one reads. Files of raw samples, whose rows are read in part, have the
// samples that GDAL reads, and use no cache.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "Pyramid/PyramidFile.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace
{
using relevo::PyramidFile;
using relevo::SampleWindow;

// GDAL counts the headers of blocks, too.
constexpr double BytesPerDataset = 1.01 * 2.0 * 1024 * 1024;

// Writes a raster whose first two levels exceed the memory of one dataset.
bool WritePyramid(const std::string& name, const std::vector<std::string>& options)
{
  RelevoRaster raster;
  raster.Width = 1500;
  raster.Height = 1300;
  raster.Type = GDT_Float64;
  raster.Options = options;
  raster.SetValues([](int, int column, int row) { return 7.0 * column - 3.0 * row; });
  if (!raster.Write(name))
  {
    return false;
  }
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_Update);
  const int factors[] = { 2, 4 };
  const bool isBuilt = dataset &&
    GDALBuildOverviews(
      dataset, "AVERAGE", 2, const_cast<int*>(factors), 0, nullptr, nullptr, nullptr) == CE_None;
  GDALClose(dataset);
  return isBuilt;
}

std::vector<SampleWindow> GetWindows(const PyramidFile& file, int size)
{
  std::vector<SampleWindow> windows;
  for (int level = 0; level < file.GetNumberOfLevels(); ++level)
  {
    const std::array<int, 2>& all = file.GetSize(level);
    for (int row = 0; row < all[1]; row += size)
    {
      for (int column = 0; column < all[0]; column += size)
      {
        windows.push_back(
          { level, column, row, std::min(size, all[0] - column), std::min(size, all[1] - row) });
      }
    }
  }
  return windows;
}

double GetCachedBytes()
{
  return static_cast<double>(GDALGetCacheUsed64());
}

// In rows of windows, and in a random order that returns to earlier windows.
void TestMemory(RelevoCheck& check, const std::string& name, int size, bool isShared)
{
  CHECK_CASE(name);
  CHECK_CASE(size);
  const double before = GetCachedBytes();
  std::string error;
  const std::unique_ptr<PyramidFile> file = PyramidFile::Open(name, error);
  if (!CHECK(file != nullptr))
  {
    return;
  }
  std::vector<SampleWindow> windows = GetWindows(*file, size);
  std::mt19937 random(5);
  for (bool isRandom : { false, true })
  {
    if (isRandom)
    {
      std::shuffle(windows.begin(), windows.end(), random);
    }
    double largest = 0.0;
    std::vector<double> samples;
    for (const SampleWindow& window : windows)
    {
      samples.resize(window.GetNumberOfSamples());
      CHECK(file->Read(window, samples.data(), error));
      largest = std::max(largest, GetCachedBytes() - before);
    }
    CHECK_EQUAL(largest == 0.0, isShared);
    CHECK_LESS_EQUAL(largest, BytesPerDataset);
  }
  file->CloseIdleHandles();
  CHECK_EQUAL(GetCachedBytes(), before);
  double sample = 0.0;
  CHECK(file->Read({ 0, 3, 2, 1, 1 }, &sample, error));
  CHECK_EQUAL(sample, 15.0);
}

// A file of raw samples with a header of VRT, in the given byte order. The line offset can be
// negative.
void TestRaw(RelevoCheck& check, const RelevoTestFolders& folders, GDALDataType type,
  const std::string& order, bool isFromBottom)
{
  CHECK_CASE(type);
  CHECK_CASE(order);
  CHECK_CASE(isFromBottom);
  constexpr int width = 300;
  constexpr int height = 200;
  constexpr int header = 12;
  const int size = GDALGetDataTypeSizeBytes(type);
  const int line = (width + 3) * size;
  std::vector<unsigned char> bytes(header + static_cast<std::size_t>(line) * height);
  std::mt19937 random(7);
  for (unsigned char& byte : bytes)
  {
    byte = static_cast<unsigned char>(random());
  }
  std::ofstream(folders.File("PyramidFile.raw"), std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
  const std::string name = folders.File("PyramidFileRaw.vrt");
  std::ofstream(name) << "<VRTDataset rasterXSize='" << width << "' rasterYSize='" << height
                      << "'><VRTRasterBand dataType='" << GDALGetDataTypeName(type)
                      << "' band='1' subClass='VRTRawRasterBand'>"
                      << "<SourceFilename relativetoVRT='1'>PyramidFile.raw</SourceFilename>"
                      << "<ImageOffset>" << header + (isFromBottom ? (height - 1) * line : 0)
                      << "</ImageOffset><PixelOffset>" << size << "</PixelOffset><LineOffset>"
                      << (isFromBottom ? -line : line) << "</LineOffset><ByteOrder>" << order
                      << "</ByteOrder></VRTRasterBand></VRTDataset>";
  std::vector<double> expected(width * height);
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_ReadOnly);
  CHECK(dataset &&
    GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Read, 0, 0, width, height, expected.data(),
      width, height, GDT_Float64, 0, 0) == CE_None);
  GDALClose(dataset);
  const double before = GetCachedBytes();
  std::string error;
  const std::unique_ptr<PyramidFile> file = PyramidFile::Open(name, error);
  if (!CHECK(file != nullptr))
  {
    return;
  }
  CHECK(!file->HasRowBlocks());
  int defects = 0;
  for (const SampleWindow& window : GetWindows(*file, 70))
  {
    std::vector<double> samples(window.GetNumberOfSamples());
    CHECK(file->Read(window, samples.data(), error));
    for (int i = 0; i < window.Width * window.Height; ++i)
    {
      const double value =
        expected[(window.Row + i / window.Width) * width + window.Column + i % window.Width];
      const bool isSame = samples[i] == value || (!std::isfinite(value) && std::isnan(samples[i]));
      defects += isSame ? 0 : 1;
    }
  }
  CHECK_EQUAL(defects, 0);
  CHECK_EQUAL(GetCachedBytes(), before);
}

// More threads than datasets.
void TestThreads(RelevoCheck& check, const std::string& name)
{
  constexpr int numberOfThreads = 80;
  const double before = GetCachedBytes();
  std::string error;
  const std::unique_ptr<PyramidFile> file = PyramidFile::Open(name, error);
  if (!CHECK(file != nullptr))
  {
    return;
  }
  const std::vector<SampleWindow> windows = GetWindows(*file, 150);
  std::vector<std::vector<double>> expected;
  for (const SampleWindow& window : windows)
  {
    expected.emplace_back(window.GetNumberOfSamples());
    CHECK(file->Read(window, expected.back().data(), error));
  }
  std::atomic<int> defects{ 0 };
  std::vector<std::thread> threads;
  for (int thread = 0; thread < numberOfThreads; ++thread)
  {
    threads.emplace_back(
      [&, thread]
      {
        std::string problem;
        for (std::size_t i = thread % 7; i < windows.size(); i += 7)
        {
          std::vector<double> samples(windows[i].GetNumberOfSamples());
          const bool isRead = file->Read(windows[i], samples.data(), problem);
          defects += isRead && samples == expected[i] ? 0 : 1;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  CHECK_EQUAL(defects, 0);
  CHECK_LESS_EQUAL(GetCachedBytes() - before, numberOfThreads * BytesPerDataset);
  file->CloseIdleHandles();
  CHECK_EQUAL(GetCachedBytes(), before);
}
}

int TestPyramidFile(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  GDALAllRegister();
  const std::string tiles = folders.File("PyramidFileTiles.tif");
  const std::string rows = folders.File("PyramidFileRows.tif");
  if (!CHECK(WritePyramid(tiles, { "TILED=YES", "BLOCKXSIZE=128", "BLOCKYSIZE=128" })) ||
    !CHECK(WritePyramid(rows, { "BLOCKYSIZE=16" })))
  {
    return check.GetResult();
  }
  TestMemory(check, tiles, 100, true);
  TestMemory(check, tiles, 300, true);
  TestMemory(check, rows, 100, false);
  for (const GDALDataType type : { GDT_Byte, GDT_Int16, GDT_Float32, GDT_Float64 })
  {
    TestRaw(check, folders, type, "LSB", false);
    TestRaw(check, folders, type, "MSB", true);
  }
  TestThreads(check, tiles);
  TestThreads(check, rows);
  return check.GetResult();
}

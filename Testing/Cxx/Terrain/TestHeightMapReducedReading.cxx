// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves terrain.md on large rasters: they are read from the smallest overview that suffices, and
// only the reduced map is held in memory.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoSanitizer.h"
#include "RelevoWarnings.h"

#include "vtkHeightMap.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <fstream>
#include <iostream>

namespace
{
// The overview is read: the full raster, 5000 million heights, would take minutes. The overview has
// other heights, which shows that they come from it.
void TestOverviews(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("HeightMapReducedOverviews.tif");
  for (const char* mode : { "none", "no-data" })
  {
    CHECK_CASE(mode);
    const bool hasNoData = mode == std::string("no-data");
    char** options = nullptr;
    for (const char* option : { "TILED=YES", "SPARSE_OK=TRUE", "COMPRESS=DEFLATE", "BIGTIFF=YES" })
    {
      options = CSLAddString(options, option);
    }
    GDALDatasetH dataset =
      GDALCreate(GDALGetDriverByName("GTiff"), name.c_str(), 100001, 50001, 1, GDT_Int16, options);
    CSLDestroy(options);
    double transform[6] = { 300000.0, 5.0, 0.0, 5200000.0, 0.0, -5.0 };
    GDALSetGeoTransform(dataset, transform);
    if (hasNoData)
    {
      GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, 1), -7.0);
    }
    const int factors[2] = { 50, 200 };
    CHECK_EQUAL(
      GDALBuildOverviews(dataset, "NONE", 2, factors, 0, nullptr, nullptr, nullptr), CE_None);
    for (int level = 0; level < 2; ++level)
    {
      GDALRasterBandH band = GDALGetOverview(GDALGetRasterBand(dataset, 1), level);
      const int width = GDALGetRasterBandXSize(band);
      const int height = GDALGetRasterBandYSize(band);
      std::vector<short> heights(static_cast<std::size_t>(width) * height);
      for (std::size_t i = 0; i < heights.size(); ++i)
      {
        const bool isVoid = hasNoData && i / width > static_cast<std::size_t>(height / 2);
        heights[i] = static_cast<short>(isVoid ? -7 : 1000 * (level + 1));
      }
      CHECK_EQUAL(GDALRasterIO(band, GF_Write, 0, 0, width, height, heights.data(), width, height,
                    GDT_Int16, 0, 0),
        CE_None);
    }
    GDALClose(dataset);
    vtkNew<vtkTerrainSource> source;
    RelevoWarnings warnings(source);
    source->SetFileName(name.c_str());
    vtkHeightMap* map = source->GetHeightMap();
    for (const auto& one :
      { std::pair<int, double>{ 2001, 1000.0 }, { 700, 1000.0 }, { 501, 2000.0 }, { 64, 2000.0 } })
    {
      warnings.Number = 0;
      source->SetMaximumDimension(one.first);
      source->Update();
      CHECK(warnings.Number == 1 && map->GetDimensions()[0] == one.first);
      CHECK_EQUAL(map->GetFullDimensions()[0], 100001);
      CHECK(map->GetRange()[0] == one.second && map->GetRange()[1] == one.second);
      CHECK(map->HasNoData() == hasNoData && map->IsValid(0.5, 0.9));
      CHECK_NOT_EQUAL(map->IsValid(0.5, 0.1), hasNoData);
      CHECK_NEAR(source->GetOutput()->GetBounds()[1], 250002.5, 0.05);
    }
  }
}

// Mip levels of OpenEXR, read by OpenImageIO.
void TestMipLevels(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("HeightMapReducedMips.exr");
  auto output = OIIO::ImageOutput::create(name);
  OIIO::ImageSpec spec(256, 128, 1, OIIO::TypeDesc::FLOAT);
  spec.tile_width = 32;
  spec.tile_height = 32;
  spec.attribute("textureformat", "Plain Texture"); // with mip levels
  CHECK(output && output->open(name, spec));
  for (int level = 0; level <= 8; ++level)
  {
    spec.width = std::max(1, 256 >> level);
    spec.height = std::max(1, 128 >> level);
    const std::vector<float> heights(
      static_cast<std::size_t>(spec.width) * spec.height, 10.0f + level);
    if (!CHECK(level == 0 || output->open(name, spec, OIIO::ImageOutput::AppendMIPLevel)) ||
      !CHECK(output->write_image(OIIO::TypeDesc::FLOAT, heights.data())))
    {
      return;
    }
  }
  CHECK(output->close());
  output.reset(); // completes the file
  vtkNew<vtkHeightMap> map;
  RelevoWarnings warnings(map);
  map->SetFileName(name.c_str());
  map->SetMaximumDimension(60);
  CHECK(map->Update() && map->GetDimensions()[0] == 60 && map->GetDimensions()[1] == 30);
  CHECK(map->GetRange()[0] == 12.0 && map->GetRange()[1] == 12.0);
}

// Memory stays at that of the reduced map, although 200 million heights are read (800 MB as
// floats).
[[maybe_unused]] void TestMemory(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const auto peak = []
  {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
    {
      if (line.rfind("VmHWM:", 0) == 0)
      {
        return std::stoll(line.substr(6)) / 1024; // MiB
      }
    }
    return -1LL;
  };
  const std::string name = folders.File("HeightMapReducedMemory.tif");
  char** options = nullptr;
  for (const char* option : { "TILED=YES", "SPARSE_OK=TRUE", "COMPRESS=DEFLATE" })
  {
    options = CSLAddString(options, option);
  }
  GDALDatasetH dataset =
    GDALCreate(GDALGetDriverByName("GTiff"), name.c_str(), 20000, 10000, 1, GDT_Int16, options);
  CSLDestroy(options);
  const std::vector<short> heights(20000 * 256, 50);
  CHECK_EQUAL(GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Write, 0, 0, 20000, 256,
                const_cast<short*>(heights.data()), 20000, 256, GDT_Int16, 0, 0),
    CE_None);
  GDALClose(dataset);
  if (peak() < 0)
  {
    std::cout << "No /proc/self/status: memory is not tested.\n";
    return;
  }
  vtkNew<vtkHeightMap> map;
  RelevoWarnings warnings(map);
  map->SetMaximumDimension(2000);
  map->SetFileName(name.c_str());
  const long long before = peak();
  CHECK(map->Update() && map->GetDimensions()[1] == 1000 && warnings.Number == 1);
  CHECK_EQUAL(map->GetSample(100, 990), 50.0);
  CHECK_EQUAL(map->GetSample(100, 500), 0.0);
  std::cout << "memory: " << peak() - before << " MiB more\n";
  CHECK_LESS(peak() - before, 150);
}
}

int TestHeightMapReducedReading(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  if (!RelevoHasAddressSanitizer)
  {
    TestMemory(check, folders); // first, because later tests reuse freed memory
  }
  TestOverviews(check, folders);
  TestMipLevels(check, folders);
  return check.GetResult();
}

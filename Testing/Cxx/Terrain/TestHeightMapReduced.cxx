// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves terrain.md: rasters larger than MaximumDimension are reduced to means, without shift or
// bias.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoWarnings.h"

#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

RelevoRaster MakeNoise(int width, int height, GDALDataType type)
{
  std::mt19937 random(7);
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Type = type;
  raster.SetValues([&](int, int, int) { return static_cast<double>(random() % 4000); });
  return raster;
}

// The area-weighted mean of a raster over one texel, by definition. NaN if there are no data.
double Mean(const RelevoRaster& raster, const int size[2], int column, int row)
{
  const double scale[2] = { static_cast<double>(raster.Width) / size[0],
    static_cast<double>(raster.Height) / size[1] };
  double sum = 0.0;
  double area = 0.0;
  for (int y = static_cast<int>(row * scale[1]);
       y < std::min<double>((row + 1) * scale[1], raster.Height); ++y)
  {
    for (int x = static_cast<int>(column * scale[0]);
         x < std::min<double>((column + 1) * scale[0], raster.Width); ++x)
    {
      const double part =
        (std::min(x + 1.0, (column + 1) * scale[0]) - std::max<double>(x, column * scale[0])) *
        (std::min(y + 1.0, (row + 1) * scale[1]) - std::max<double>(y, row * scale[1]));
      const double value = raster.At(0, x, y);
      const bool masked =
        !raster.Mask.empty() && !raster.Mask[static_cast<std::size_t>(y) * raster.Width + x];
      if (part > 1e-9 && !std::isnan(value) && value != raster.NoData.value_or(NaN) && !masked)
      {
        sum += part * value;
        area += part;
      }
    }
  }
  return area > 0.0 ? sum / area * raster.Scale.value_or(1.0) + raster.Offset.value_or(0.0) : NaN;
}

// Compares every height of the map, whose row 0 is the file's last row.
void CheckMeans(RelevoCheck& check, vtkHeightMap* map, const RelevoRaster& raster,
  const int size[2], double tolerance)
{
  CHECK(map->GetDimensions()[0] == size[0] && map->GetDimensions()[1] == size[1]);
  CHECK(
    map->GetFullDimensions()[0] == raster.Width && map->GetFullDimensions()[1] == raster.Height);
  double worst = 0.0;
  int wrong = 0;
  double range[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  for (int row = 0; row < size[1] && map->GetSamples(); ++row)
  {
    for (int column = 0; column < size[0]; ++column)
    {
      const std::size_t index = static_cast<std::size_t>(size[1] - 1 - row) * size[0] + column;
      const double expected = Mean(raster, size, column, row);
      const bool isValid = !map->GetValidity() || map->GetValidity()[index];
      wrong += isValid == std::isnan(expected);
      if (isValid && !std::isnan(expected))
      {
        worst = std::max(worst, std::abs(map->GetSamples()[index] - expected));
        range[0] = std::min<double>(range[0], map->GetSamples()[index]);
        range[1] = std::max<double>(range[1], map->GetSamples()[index]);
      }
    }
  }
  CHECK_NEAR(worst, 0.0, tolerance);
  CHECK_EQUAL(wrong, 0);
  CHECK(map->GetRange()[0] == range[0] && map->GetRange()[1] == range[1]);
}

void TestLayouts(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("HeightMapReduced.tif");
  const int size[2] = { 100, 59 }; // 303 x 100 / 517 is 58.6
  for (GDALDataType type : { GDT_Byte, GDT_UInt16, GDT_Int16, GDT_Float32, GDT_Float64 })
  {
    for (const char* tiled : { "YES", "NO" })
    {
      RelevoRaster raster = MakeNoise(517, 303, type);
      if (type == GDT_Byte)
      {
        std::transform(raster.Values.begin(), raster.Values.end(), raster.Values.begin(),
          [](double value) { return std::fmod(value, 256.0); });
      }
      raster.Options = { std::string("TILED=") + tiled, "COMPRESS=LZW" };
      CHECK(raster.Write(name));
      vtkNew<vtkHeightMap> map;
      RelevoErrors errors(map);
      RelevoWarnings warnings(map);
      map->SetMaximumDimension(100);
      map->SetFileName(name.c_str());
      CHECK(map->Update() && map->Update() && !map->HasNoData());
      CHECK_EQUAL(warnings.Number, 1);
      for (const char* words : { "517 x 303", "100 x 59", "MaximumDimension", "gdal_translate" })
      {
        CHECK_CASE(words);
        CHECK_NOT_EQUAL(warnings.Text.find(words), std::string::npos);
      }
      CheckMeans(check, map, raster, size, 2e-4);
      // A raster that is not too large is unchanged and gives no warning.
      map->SetMaximumDimension(517);
      CHECK(map->Update() && map->GetDimensions()[1] == 303 && warnings.Number == 1);
      CHECK_EQUAL(map->GetSample(5, 302), raster.At(0, 5, 0));
      map->SetMaximumDimension(0);
      CHECK(map->Update() && map->GetDimensions()[0] == 517 && warnings.Number == 1);
    }
  }
  // Thin rasters keep at least one texel along their shorter side.
  for (const auto& shape : { std::pair<int, int>{ 1, 4321 }, { 4321, 1 }, { 4321, 3 } })
  {
    const RelevoRaster raster = MakeNoise(shape.first, shape.second, GDT_Int16);
    CHECK(raster.Write(name));
    vtkNew<vtkHeightMap> map;
    RelevoWarnings warnings(map);
    map->SetMaximumDimension(64);
    map->SetFileName(name.c_str());
    CHECK(map->Update() && warnings.Number == 1);
    const int thin[2] = { std::min(shape.first, 64), std::min(shape.second, 64) };
    const int expected[2] = { shape.first == 1 ? 1 : thin[0], shape.second < 4 ? 1 : thin[1] };
    CheckMeans(check, map, raster, expected, 2e-4);
  }
}

// Missing samples of every kind are left out of the means.
void TestNoData(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("HeightMapReducedNoData.tif");
  const int size[2] = { 40, 30 };
  RelevoRaster raster = MakeNoise(200, 150, GDT_Float32);
  for (int i = 0; i < 200 * 150; ++i)
  {
    const int column = i % 200;
    const int row = i / 200;
    if (std::hypot(column - 120.0, row - 60.0) < 33.3 || i % 37 == 0)
    {
      raster.Values[i] = -9999.0;
    }
  }
  const auto verify = [&](vtkHeightMap* map)
  {
    RelevoWarnings warnings(map);
    map->SetMaximumDimension(40);
    map->SetFileName(name.c_str());
    CHECK(map->Update() && map->HasNoData() && warnings.Number == 1);
    CHECK_GREATER_EQUAL(map->GetRange()[0], 0.0);
    CheckMeans(check, map, raster, size, 1e-3);
  };
  raster.NoData = -9999.0;
  CHECK(raster.Write(name));
  verify(vtkNew<vtkHeightMap>());

  // The file declares scale and offset.
  raster.Scale = 0.5;
  raster.Offset = 70.0;
  CHECK(raster.Write(name));
  verify(vtkNew<vtkHeightMap>());
  raster.Scale.reset();
  raster.Offset.reset();

  // The user sets the no-data value.
  raster.NoData.reset();
  CHECK(raster.Write(name));
  raster.NoData = -9999.0;
  vtkNew<vtkHeightMap> told;
  told->SetNoDataValue(-9999.0);
  verify(told);

  // NaN is missing.
  raster.NoData.reset();
  std::replace(raster.Values.begin(), raster.Values.end(), -9999.0, NaN);
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> toldNaN;
  toldNaN->SetNoDataValue(NaN);
  verify(toldNaN);
  // NaN that is not declared as missing is an error, as without reduction.
  vtkNew<vtkHeightMap> notTold;
  RelevoErrors errors(notTold);
  notTold->SetMaximumDimension(40);
  notTold->SetFileName(name.c_str());
  CHECK(!notTold->Update() && errors.Said("of 30000 heights are NaN"));
  CHECK_EQUAL(notTold->GetFullDimensions()[0], 0);

  // A mask marks missing samples.
  for (double& value : raster.Values)
  {
    raster.Mask.push_back(std::isnan(value) ? 0 : 255);
    value = std::isnan(value) ? 123456.0 : value;
  }
  CHECK(raster.Write(name));
  verify(vtkNew<vtkHeightMap>());
}

// The result equals that of gdal_translate -r average.
void TestAgainstGDAL(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("HeightMapReducedGDAL.tif");
  const std::string reduced = folders.File("HeightMapReducedByGDAL.tif");
  for (bool withNoData : { false, true })
  {
    CHECK_CASE(withNoData);
    RelevoRaster raster = MakeNoise(800, 370, GDT_Float32);
    if (withNoData)
    {
      raster.NoData = -1.0;
      for (int i = 0; i < 800 * 370; ++i)
      {
        raster.Values[i] = i % 800 > 613 && i / 800 > 201 ? -1.0 : raster.Values[i];
      }
    }
    CHECK(raster.Write(name));
    vtkNew<vtkHeightMap> map;
    RelevoWarnings warnings(map);
    map->SetMaximumDimension(300);
    map->SetFileName(name.c_str());
    CHECK(map->Update());

    GDALDatasetH source = GDALOpen(name.c_str(), GA_ReadOnly);
    const char* arguments[] = { "-r", "average", "-outsize", "300", "139", nullptr };
    GDALTranslateOptions* options = GDALTranslateOptionsNew(const_cast<char**>(arguments), nullptr);
    GDALClose(GDALTranslate(reduced.c_str(), source, options, nullptr));
    GDALTranslateOptionsFree(options);
    GDALClose(source);
    const RelevoRaster expected = RelevoRaster::Read(reduced);
    CHECK(expected.Width == map->GetDimensions()[0] && expected.Height == map->GetDimensions()[1]);
    double worst = 0.0;
    int wrong = 0;
    for (int i = 0; i < expected.Width * expected.Height; ++i)
    {
      const std::size_t index =
        static_cast<std::size_t>(expected.Height - 1 - i / 300) * 300 + i % 300;
      const bool isValid = !map->GetValidity() || map->GetValidity()[index];
      wrong += isValid == (expected.Values[i] == -1.0);
      worst =
        std::max(worst, isValid ? std::abs(map->GetSamples()[index] - expected.Values[i]) : 0.0);
    }
    CHECK_EQUAL(wrong, 0);
    CHECK_NEAR(worst, 0.0, 2e-3);
  }
}

// A plane stays the same plane for files in all orientations: means lie at the centres of the areas
// they cover. The terrain keeps the location of the whole raster.
void TestRegistration(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("HeightMapReducedPlane.tif");
  for (int turn = 0; turn < 4; ++turn)
  {
    const double dx = turn % 2 ? -10.0 : 10.0;
    const double dy = turn / 2 ? 10.0 : -10.0;
    RelevoRaster raster;
    raster.Width = 320;
    raster.Height = 200;
    raster.Transform = { 500000.0 + (dx < 0.0 ? 3200.0 : 0.0), dx, 0.0,
      5000000.0 + (dy > 0.0 ? -2000.0 : 0.0), 0.0, dy };
    raster.CoordinateSystem = "EPSG:32633";
    raster.SetValues(
      [&](int, int column, int row)
      {
        const double x = raster.Transform[0] + dx * (column + 0.5);
        const double y = raster.Transform[3] + dy * (row + 0.5);
        return 0.5 * (x - 500000.0) + 0.25 * (y - 5000000.0);
      });
    CHECK(raster.Write(name));
    vtkNew<vtkTerrainSource> source;
    RelevoWarnings warnings(source);
    RelevoErrors errors(source->GetHeightMap());
    source->SetMaximumDimension(64);
    CHECK_EQUAL(source->GetMaximumDimension(), 64);
    source->SetFileName(name.c_str());
    source->SetResolution(16);
    source->Update();
    source->Update();
    CHECK(warnings.Number == 1 && warnings.Text.find("64 x 40") != std::string::npos);
    double bounds[6];
    source->GetOutput()->GetBounds(bounds);
    CHECK(bounds[0] == -1600.0 && bounds[1] == 1600.0);
    CHECK(bounds[2] == -1000.0 && bounds[3] == 1000.0);
    CHECK(source->GetOrigin()[0] == 501600.0 && source->GetOrigin()[1] == 4999000.0);
    double worst = 0.0;
    for (double u = 0.05; u < 0.95; u += 0.0371)
    {
      for (double v = 0.05; v < 0.95; v += 0.0293)
      {
        const double terrain[3] = { (u - 0.5) * 3200.0, (v - 0.5) * 2000.0, 0.0 };
        double map[3];
        CHECK(source->TerrainToMap(terrain, map));
        worst = std::max(worst,
          std::abs(source->GetHeightMap()->GetHeight(u, v) - 0.5 * (map[0] - 500000.0) -
            0.25 * (map[1] - 5000000.0)));
      }
    }
    CHECK_NEAR(worst, 0.0, 1e-3);
  }

  // For an image in memory without georeference, texels of the full image are the unit.
  vtkNew<vtkImageData> image;
  image->SetDimensions(300, 100, 1);
  image->AllocateScalars(VTK_SHORT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, static_cast<double>(4 * (i % 300)));
  }
  vtkNew<vtkTerrainSource> source;
  RelevoWarnings warnings(source);
  source->GetHeightMap()->SetImageData(image);
  source->SetMaximumDimension(60);
  CHECK(source->GetHeightMap()->UpdateInformation());
  CHECK_EQUAL(source->GetHeightMap()->GetFullDimensions()[0], 300);
  source->Update();
  CHECK(warnings.Number == 1 && warnings.Text.find("The image has 300 x 100") != std::string::npos);
  CHECK_EQUAL(source->GetHeightMap()->GetDimensions()[1], 20);
  CHECK_EQUAL(source->GetHeightMap()->GetSample(7, 3), 4.0f * 37);
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  CHECK(bounds[0] == -150.0 && bounds[1] == 150.0 && bounds[3] == 50.0);
}
}

int TestHeightMapReduced(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestLayouts(check, folders);
  TestNoData(check, folders);
  TestAgainstGDAL(check, folders);
  TestRegistration(check, folders);
  return check.GetResult();
}

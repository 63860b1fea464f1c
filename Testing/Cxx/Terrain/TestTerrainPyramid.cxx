// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainPyramid promises the height of the full resolution at any coordinates: bilinear between
// the centers of samples, NaN without data and outside, within a limit of memory.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// The reference: bilinear between centers, constant beyond the outermost ones. Column and row are
// whole numbers at the centers; row 0 is the first of the file.
double Interpolate(const RelevoRaster& raster, double column, double row)
{
  const double x = std::clamp(column, 0.0, raster.Width - 1.0);
  const double y = std::clamp(row, 0.0, raster.Height - 1.0);
  double sum = 0.0;
  for (int j = 0; j < raster.Height; ++j)
  {
    for (int i = 0; std::abs(y - j) < 1.0 && i < raster.Width; ++i)
    {
      const double weight = std::max(0.0, 1.0 - std::abs(x - i)) * (1.0 - std::abs(y - j));
      if (weight > 0.0)
      {
        const double value = raster.At(0, i, j);
        sum += weight *
          (raster.NoData && value == *raster.NoData
              ? NaN
              : value * raster.Scale.value_or(1.0) + raster.Offset.value_or(0.0));
      }
    }
  }
  return sum;
}

bool AreSame(double a, double b, double tolerance)
{
  return std::isnan(a) ? std::isnan(b) : std::abs(a - b) <= tolerance;
}

// Heights at random points and at all kinds of borders, alone and in an array.
void TestQueries(RelevoCheck& check, const RelevoRaster& raster, const std::string& name)
{
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK_EQUAL(pyramid->GetDimensions()[0], raster.Width);
  CHECK_EQUAL(pyramid->GetDimensions()[1], raster.Height);
  CHECK_EQUAL(pyramid->GetNumberOfLevels(), 1);

  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const std::vector<double>& t = raster.Transform;
  vtkNew<vtkDoubleArray> points;
  points->SetNumberOfComponents(2);
  std::vector<double> expected;
  for (int i = 0; i < 2000; ++i)
  {
    // Every fourth point is at a center of a sample, where neighbors do not contribute.
    double column = share(random) * raster.Width - 0.5;
    double row = share(random) * raster.Height - 0.5;
    if (i % 4 == 0)
    {
      column = std::clamp(std::round(column), 0.0, raster.Width - 1.0);
      row = std::clamp(std::round(row), 0.0, raster.Height - 1.0);
    }
    points->InsertNextTuple2(t[0] + t[1] * (column + 0.5) + t[2] * (row + 0.5),
      t[3] + t[4] * (column + 0.5) + t[5] * (row + 0.5));
    expected.push_back(Interpolate(raster, column, row));
  }
  auto heights = vtkSmartPointer<vtkDoubleArray>::Take(pyramid->GetElevations(points));
  CHECK_EQUAL(heights->GetNumberOfTuples(), points->GetNumberOfTuples());
  int different = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    const double* point = points->GetTuple2(i);
    const double height = pyramid->GetElevation(point[0], point[1]);
    different += AreSame(expected[i], height, 1e-5) ? 0 : 1;
    different += AreSame(heights->GetValue(i), height, 0.0) ? 0 : 1;
  }
  CHECK_EQUAL(different, 0);
  CHECK(errors.None());
}

RelevoRaster MakeRaster(GDALDataType type, const std::vector<double>& transform)
{
  RelevoRaster raster;
  raster.Width = 617;
  raster.Height = 530;
  raster.Type = type;
  raster.Transform = transform;
  raster.SetValues([](int, int column, int row)
    { return std::floor(500.0 + 300.0 * std::sin(0.05 * column) * std::cos(0.07 * row)); });
  return raster;
}

void TestRasters(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> degrees = { 10.0, 0.01, 0.0, 50.0, 0.0, -0.01 };
  const std::vector<double> southUp = { 10.0, 0.01, 0.0, 40.0, 0.0, 0.01 };
  const std::vector<double> rotated = { 5e5, 20.0, 7.0, 4e6, 6.0, -22.0 };
  struct Case
  {
    const char* Name;
    GDALDataType Type;
    std::vector<double> Transform;
    const char* System;
    bool HasNoData;
    bool IsScaled;
    bool IsTiled;
  };
  const Case cases[] = {
    { "degrees", GDT_Int16, degrees, "EPSG:4326", true, false, true },
    { "south up", GDT_UInt16, southUp, "EPSG:4326", false, true, false },
    { "rotated", GDT_Float32, rotated, "EPSG:32633", true, false, false },
    { "double", GDT_Float64, rotated, "EPSG:32633", true, true, true },
    { "int32", GDT_Int32, degrees, "EPSG:4326", false, false, true },
  };
  for (const Case& one : cases)
  {
    CHECK_CASE(one.Name);
    RelevoRaster raster = MakeRaster(one.Type, one.Transform);
    raster.CoordinateSystem = one.System;
    if (one.Type == GDT_Int32 || one.Type == GDT_Float64)
    {
      raster.Values[0] = 123456789.0; // more digits than a float has
    }
    if (one.HasNoData)
    {
      raster.NoData = -9999.0;
      for (int i = 0; i < 20000; ++i)
      {
        raster.Values[100000 + (7 * i) % 150000] = -9999.0;
      }
    }
    if (one.IsScaled)
    {
      raster.Scale = 0.1;
      raster.Offset = -40.0;
    }
    if (one.IsTiled)
    {
      raster.Options = { "TILED=YES", "BLOCKXSIZE=128", "BLOCKYSIZE=128", "COMPRESS=DEFLATE" };
    }
    TestQueries(check, raster, folders.File("TerrainPyramid.tif"));
  }
}

// Longitudes count modulo 360 degrees; other coordinates outside have no height.
void TestBorders(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(GDT_Int16, { 170.0, 0.05, 0.0, 20.0, 0.0, -0.05 });
  raster.CoordinateSystem = "EPSG:4326"; // from 170 to 200.85 degrees
  const std::string name = folders.File("TerrainPyramidBorders.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK_NEAR(pyramid->GetElevation(-170.0, 5.0), pyramid->GetElevation(190.0, 5.0), 1e-9);
  CHECK_NEAR(pyramid->GetElevation(175.0, 5.0), pyramid->GetElevation(-185.0, 5.0), 1e-9);
  CHECK(std::isnan(pyramid->GetElevation(0.0, 5.0)));
  CHECK(std::isnan(pyramid->GetElevation(180.0, 20.1)));
  CHECK(std::isnan(pyramid->GetElevation(NaN, 5.0)));
  CHECK_EQUAL(pyramid->GetElevation(170.0, 20.0), raster.At(0, 0, 0)); // the corner of the border
  CHECK(errors.None());

  // Without a georeference a texel is a unit, and y = 0 is the lower border.
  raster.Transform.clear();
  raster.CoordinateSystem.clear();
  CHECK(raster.Write(name));
  CHECK(pyramid->Update());
  CHECK_EQUAL(pyramid->GetElevation(0.5, 0.5), raster.At(0, 0, raster.Height - 1));
  CHECK_EQUAL(pyramid->GetElevation(616.5, 529.5), raster.At(0, 616, 0));
}

// Tiles beyond the limit are dropped, and read again when they are needed.
void TestMemoryLimit(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeSlope(2048, 1536, { 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 }, "");
  raster.Type = GDT_Float64;
  const std::string name = folders.File("TerrainPyramidMemory.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  constexpr vtkTypeInt64 limit = 2 << 20; // the raster has 24 MiB
  pyramid->SetMemoryLimit(limit);
  CHECK(pyramid->Update());
  vtkTypeInt64 largest = 0;
  int different = 0;
  for (int i = 0; i < 400; ++i)
  {
    const int column = (i * 977) % raster.Width;
    const int row = (i * 131) % raster.Height;
    different +=
      pyramid->GetElevation(column + 0.5, -row - 0.5) == raster.At(0, column, row) ? 0 : 1;
    largest = std::max(largest, pyramid->GetResidentMemorySize());
  }
  CHECK_EQUAL(different, 0);
  CHECK_LESS_EQUAL(largest, limit);
  CHECK_GREATER(largest, limit / 2);
  pyramid->SetMemoryLimit(1 << 20);
  CHECK_LESS_EQUAL(pyramid->GetResidentMemorySize(), 1 << 20);
}

// A pixel of real data, compared with GDAL.
void TestRealData(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.RealData + "mt_rainier_90m.tif";
  const RelevoRaster raster = RelevoRaster::Read(name);
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  pyramid->SetCacheDirectory(folders.File("TerrainPyramidCache").c_str());
  CHECK(pyramid->Update());
  int different = 0;
  double t[6] = { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_ReadOnly);
  GDALGetGeoTransform(dataset, t);
  GDALClose(dataset);
  for (int i = 0; i < 1000; ++i)
  {
    const int column = (i * 977) % raster.Width;
    const int row = (i * 131) % raster.Height;
    const double height =
      pyramid->GetElevation(t[0] + t[1] * (column + 0.5), t[3] + t[5] * (row + 0.5));
    const double value = raster.At(0, column, row);
    const bool isMissing = raster.NoData && value == *raster.NoData;
    different += AreSame(isMissing ? NaN : value, height, 1e-3) ? 0 : 1;
  }
  CHECK_EQUAL(different, 0);
}
}

int TestTerrainPyramid(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestRasters(check, folders);
  TestBorders(check, folders);
  TestMemoryLimit(check, folders);
  if (!folders.RealData.empty())
  {
    TestRealData(check, folders);
  }
  return check.GetResult();
}

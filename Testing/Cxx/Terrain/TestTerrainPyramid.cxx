// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainPyramid promises the height of the full resolution at any coordinates: bilinear between
// the centers of samples, NaN without data and outside, within a limit of memory.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

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
// Heights in feet, beyond the antimeridian. One sample has no data.
RelevoRaster MakePlaces()
{
  RelevoRaster raster;
  raster.Width = 900;
  raster.Height = 700;
  raster.Type = GDT_Int16;
  raster.NoData = -1.0;
  raster.Unit = "ft";
  raster.Transform = { 190.0, 0.1, 0.0, 35.0, 0.0, -0.1 };
  raster.CoordinateSystem = "EPSG:4326";
  raster.SetValues(
    [](int, int column, int row) {
      return column == 20 && row == 30 ? -1.0 : static_cast<double>(column / 100) * 1000.0 + row;
    });
  return raster;
}

// Before Update() there are no places.
void TestNoPlaces(RelevoCheck& check)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  const double region[4] = { 195.1, 196.9, 20.1, 22.9 };
  double place[2] = { 190.05, 34.95 };
  double sample[2] = { 0.0, 0.0 };
  double range[2] = { 7.0, 7.0 };
  CHECK(!pyramid->RasterToSample(place, sample));
  CHECK(!pyramid->SampleToRaster(sample, place));
  CHECK(!pyramid->GetRangeOfRegion(region, range));
  CHECK(!pyramid->IsGeographic() && !pyramid->HasGeoreference());
  CHECK_EQUAL(pyramid->GetVerticalUnit(), 1.0);
  CHECK(pyramid->GetBounds()[0] > pyramid->GetBounds()[1]);
  RelevoErrors errors(pyramid);
  CHECK(std::isnan(pyramid->GetNearestElevation(0.0, 0.0)));
  CHECK(errors.Said("Update()"));
  CHECK(pyramid->GetReducedElevations(10) == nullptr);
  CHECK(errors.Said("Update()"));
}

void TestConversions(RelevoCheck& check, vtkTerrainPyramid* pyramid)
{
  CHECK(pyramid->IsGeographic() && pyramid->HasGeoreference());
  CHECK_NEAR(pyramid->GetVerticalUnit(), 0.3048, 1e-9);
  CHECK_EQUAL(std::string(pyramid->GetLocationWarning()), std::string());
  const double* bounds = pyramid->GetBounds();
  CHECK_NEAR(bounds[0], 190.0, 1e-9);
  CHECK_NEAR(bounds[1], 280.0, 1e-9);
  CHECK_NEAR(bounds[2], -35.0, 1e-9);
  CHECK_NEAR(bounds[3], 35.0, 1e-9);
  // The first sample, a sample by its longitude minus 360, and a point outside.
  for (const auto& [x, y, column, row] :
    std::vector<std::array<double, 4>>{ { { 190.05, 34.95, 0.0, 0.0 } },
      { { -100.0 + 0.05, 34.85, 700.0, 1.0 } }, { { 180.05, 36.95, -100.0, -20.0 } } })
  {
    double place[2] = { x, y };
    double sample[2];
    CHECK(pyramid->RasterToSample(place, sample));
    CHECK_NEAR(sample[0], column, 1e-6);
    CHECK_NEAR(sample[1], row, 1e-6);
    CHECK(pyramid->SampleToRaster(sample, place));
    CHECK_NEAR(place[1], y, 1e-9);
    CHECK_NEAR(std::remainder(place[0] - x, 360.0), 0.0, 1e-9);
  }
}

// Coordinates, columns and rows; ranges of regions contain the heights there.
void TestPlaces(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("pyramid-places.tif");
  CHECK(MakePlaces().Write(name));
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  TestConversions(check, pyramid);
  // The range is that of the tiles of 256 x 256 samples in the region.
  const double region[4] = { 195.1, 196.9, 20.1, 22.9 };
  double range[2];
  CHECK(pyramid->GetRangeOfRegion(region, range));
  CHECK_LESS_EQUAL(range[0], 120.0);
  CHECK_LESS(150.0, range[1]);
  CHECK_LESS(range[1], 3000.0);
  CHECK_LESS_EQUAL(0.0, range[0]); // no data do not count
  double whole[2];
  CHECK(pyramid->GetRangeOfRegion(pyramid->GetBounds(), whole));
  CHECK_EQUAL(whole[0], pyramid->GetRange()[0]);
  CHECK_EQUAL(whole[1], pyramid->GetRange()[1]);
  // The last columns and, 360 degrees later, the first ones.
  const double both[4] = { 275.0, 555.0, 30.0, 34.0 };
  CHECK(pyramid->GetRangeOfRegion(both, range));
  CHECK_LESS_EQUAL(range[0], 10.0);
  CHECK_LESS_EQUAL(8000.0, range[1]);
  const double outside[4] = { 100.0, 120.0, 0.0, 1.0 };
  range[0] = 7.0;
  CHECK(!pyramid->GetRangeOfRegion(outside, range));
  CHECK_EQUAL(range[0], 7.0);
  // Beside the sample without data.
  CHECK_EQUAL(pyramid->GetNearestElevation(190.05 + 2.14, 34.95 - 3.04), 30.0);
  CHECK(std::isnan(pyramid->GetElevation(190.05 + 2.08, 34.95 - 3.0)));
  CHECK(std::isnan(pyramid->GetNearestElevation(190.05 + 2.04, 34.95 - 3.0)));
  CHECK(std::isnan(pyramid->GetNearestElevation(189.9, 0.0)));
  const auto image = vtkSmartPointer<vtkImageData>::Take(pyramid->GetReducedElevations(240));
  CHECK_EQUAL(image->GetDimensions()[0], 225);
  CHECK_EQUAL(image->GetDimensions()[1], 175);
  CHECK_EQUAL(image->GetSpacing()[0], 4.0);
  CHECK_EQUAL(image->GetScalarComponentAsDouble(60, 10, 0, 0), 2040.0);
  CHECK(std::string(image->GetPointData()->GetScalars()->GetName()) == "Elevation");
  const auto full = vtkSmartPointer<vtkImageData>::Take(pyramid->GetReducedElevations(900));
  CHECK(std::isnan(full->GetScalarComponentAsDouble(20, 30, 0, 0)));
  CHECK_EQUAL(full->GetSpacing()[1], 1.0);
  RelevoErrors errors(pyramid);
  CHECK(pyramid->GetReducedElevations(1) == nullptr);
  CHECK(errors.Said("at least 2"));
}

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
  TestNoPlaces(check);
  TestPlaces(check, folders);
  TestMemoryLimit(check, folders);
  if (!folders.RealData.empty())
  {
    TestRealData(check, folders);
  }
  return check.GetResult();
}

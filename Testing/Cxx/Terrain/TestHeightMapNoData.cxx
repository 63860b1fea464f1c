// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves terrain.md on missing heights: which samples have no data, and how holes are filled.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

RelevoRaster MakeRaster(GDALDataType type)
{
  RelevoRaster raster;
  raster.Width = 6;
  raster.Height = 5;
  raster.Type = type;
  raster.SetValues([](int, int column, int row) { return 10 + column + row; });
  return raster;
}

// Column and row are those of the file.
bool IsVoid(vtkHeightMap* map, int column, int row)
{
  const int* dimensions = map->GetDimensions();
  return map->GetValidity() &&
    !map->GetValidity()[(dimensions[1] - 1 - row) * dimensions[0] + column];
}

long NumberOfVoids(vtkHeightMap* map)
{
  const int* dimensions = map->GetDimensions();
  return map->GetValidity()
    ? std::count(map->GetValidity(), map->GetValidity() + dimensions[0] * dimensions[1], 0)
    : 0;
}

// The declared value is compared in the type of the samples.
void TestDeclared(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Case
  {
    GDALDataType Type;
    double Declared;
    double Stored;
    bool Matches;
  };
  const Case cases[] = {
    { GDT_UInt16, 65535.0, 65535.0, true },
    { GDT_Int16, -32768.0, -32768.0, true },
    { GDT_Int16, -9999.0, -9999.0, true },
    { GDT_Int16, -9999.5, -9999.0, false },
    { GDT_Byte, 0.0, 0.0, true },
    { GDT_Int32, -2147483648.0, -2147483648.0, true },
    { GDT_Float32, -3.4e38, static_cast<float>(-3.4e38), true },
    { GDT_Float32, -3.4028234663852886e38, std::numeric_limits<float>::lowest(), true },
    { GDT_Float32, -9999.9, static_cast<float>(-9999.9), true },
    { GDT_Float32, NaN, NaN, true },
    { GDT_Float32, 1.0, 1.0 + 1e-6, false },
    { GDT_Float64, -1.7976931348623157e308, -1.7976931348623157e308, true },
    { GDT_Float64, NaN, NaN, true },
  };
  for (const Case& one : cases)
  {
    RelevoRaster raster = MakeRaster(one.Type);
    raster.Values[2 * 6 + 3] = one.Stored;
    raster.NoData = one.Declared;
    const std::string name = folders.File("HeightMapNoData.tif");
    CHECK(raster.Write(name));
    vtkNew<vtkHeightMap> map;
    map->SetFileName(name.c_str());
    CHECK(map->Update());
    const bool sameValue = map->GetNoDataValue() == one.Declared ||
      (std::isnan(one.Declared) && std::isnan(map->GetNoDataValue())) ||
      static_cast<float>(map->GetNoDataValue()) == static_cast<float>(one.Declared);
    if (!CHECK(sameValue) || !CHECK_EQUAL(IsVoid(map, 3, 2), one.Matches) ||
      !CHECK_EQUAL(NumberOfVoids(map), one.Matches) || !CHECK_EQUAL(map->HasNoData(), one.Matches))
    {
      std::cerr << "  declared " << one.Declared << " in " << GDALGetDataTypeName(one.Type) << "\n";
    }
    if (one.Matches)
    {
      CHECK(map->GetRange()[0] == 10.0 && map->GetRange()[1] == 19.0);
      // The mean of its neighbours, because heights form a plane.
      CHECK_NEAR(map->GetSample(3, 2), 15.0, 1e-4);
      CHECK(!map->IsValid(3.5 / 6, 2.5 / 5));
      CHECK(map->IsValid(0.5 / 6, 0.5 / 5));
    }
  }
}

// A value set by the user is used in addition to the declared one, and can be removed.
void TestSetValue(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(GDT_Float32);
  raster.Values[1] = -9999.0;
  raster.Values[2] = NaN;
  raster.NoData = -9999.0;
  const std::string name = folders.File("HeightMapSetValue.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> map;
  RelevoErrors errors(map);
  map->SetFileName(name.c_str());
  CHECK(!map->Update());
  CHECK(errors.Said("1 of 30 heights are NaN or infinite, the first in column 2, row 0"));
  CHECK(!map->Update()); // every update reports the error
  CHECK(errors.Said("SetNoDataValue"));
  CHECK(map->GetDimensions()[0] == 0 && !map->GetSamples());
  map->SetNoDataValue(NaN);
  CHECK(map->Update() && errors.None());
  CHECK(NumberOfVoids(map) == 2 && IsVoid(map, 1, 0) && IsVoid(map, 2, 0));
  const vtkMTimeType before = map->GetMTime();
  map->SetNoDataValue(NaN); // unchanged
  CHECK_EQUAL(map->GetMTime(), before);
  const vtkMTimeType samples = map->GetSamplesMTime();
  CHECK(map->Update() && map->GetSamplesMTime() == samples);
  map->SetNoDataValue(10.0);
  CHECK(!map->Update() && errors.Said("NaN"));
  CHECK_EQUAL(map->GetNoDataValue(), 10.0);
  map->UnsetNoDataValue();
  CHECK(!map->Update() && errors.Said("NaN"));
  CHECK_EQUAL(map->GetNoDataValue(), -9999.0);
  CHECK_GREATER(map->GetSamplesMTime(), samples);
}

void TestInfinite(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(GDT_Float32);
  raster.Values[4 * 6 + 5] = -std::numeric_limits<double>::infinity();
  raster.Values[3 * 6 + 1] = std::numeric_limits<double>::infinity();
  const std::string name = folders.File("HeightMapInfinite.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> map;
  RelevoErrors errors(map);
  map->SetFileName(name.c_str());
  CHECK(!map->Update());
  CHECK(errors.Said("2 of 30 heights are NaN or infinite, the first in column 1, row 3"));
}

void TestMask(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(GDT_Int16);
  raster.Mask.assign(30, 255);
  raster.Mask[4] = 0;
  const std::string name = folders.File("HeightMapMask.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  CHECK(map->Update());
  CHECK(NumberOfVoids(map) == 1 && IsVoid(map, 4, 0));
}

void TestAllVoid(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(GDT_Int16);
  std::fill(raster.Values.begin(), raster.Values.end(), -1.0);
  raster.NoData = -1.0;
  const std::string name = folders.File("HeightMapAllVoid.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkHeightMap> map;
  RelevoErrors errors(map);
  map->SetFileName(name.c_str());
  CHECK(!map->Update());
  CHECK(errors.Said("all 30 heights are missing values"));
  CHECK(errors.None() && !map->HasNoData() && !map->GetSamples());
}

// Filled heights stay in the range, are close to a plane around a hole, harmonic, and independent
// of the number of threads.
void TestFill(RelevoCheck& check)
{
  constexpr int n = 200;
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(image->GetScalarPointer());
  const auto plane = [](int x, int y) { return 2.0 * x + y; };
  const auto inHole = [](int x, int y) { return std::hypot(x - 90, y - 110) < 40.0; };
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      samples[y * n + x] = inHole(x, y) ? -9999.0f : static_cast<float>(plane(x, y));
    }
  }
  vtkNew<vtkHeightMap> map;
  map->SetImageData(image);
  map->SetNoDataValue(-9999.0);
  CHECK(map->Update());
  const std::vector<float> filled(map->GetSamples(), map->GetSamples() + n * n);
  double deviation = 0.0;
  double step = 0.0;
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      if (inHole(x, y))
      {
        deviation = std::max(deviation, std::abs(filled[y * n + x] - plane(x, y)));
        step = std::max(step, std::abs(double(filled[y * n + x]) - filled[y * n + x + 1]));
        step = std::max(step, std::abs(double(filled[y * n + x]) - filled[y * n + x - 1]));
      }
    }
  }
  std::cout << "fill of a hole in a plane: deviation " << deviation << ", largest step " << step
            << "\n";
  CHECK_LESS(deviation, 0.05 * 80.0 * std::sqrt(5.0)); // relative to the relief across the hole
  // Relative to the plane's slope: no spikes and no cliffs.
  CHECK_LESS(step, 2.0 * 2.0);

  vtkSMPTools::Initialize(1);
  vtkNew<vtkHeightMap> alone;
  alone->SetImageData(image);
  alone->SetNoDataValue(-9999.0);
  CHECK(alone->Update());
  CHECK(std::equal(filled.begin(), filled.end(), alone->GetSamples()));
  vtkSMPTools::Initialize();
}

// A single valid sample fills the map.
void TestSingleValid(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(37, 11, 1);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* samples = static_cast<short*>(image->GetScalarPointer());
  std::fill_n(samples, 37 * 11, static_cast<short>(-1));
  samples[5] = 42;
  vtkNew<vtkHeightMap> map;
  map->SetImageData(image);
  map->SetNoDataValue(-1.0);
  CHECK(map->Update());
  CHECK(std::all_of(map->GetSamples(), map->GetSamples() + 37 * 11,
    [](float height) { return std::abs(height - 42.0f) < 1e-4f; }));
  CHECK(map->GetRange()[0] == 42.0 && map->GetRange()[1] == 42.0);
}
}

int TestHeightMapNoData(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestDeclared(check, folders);
  TestSetValue(check, folders);
  TestInfinite(check, folders);
  TestMask(check, folders);
  TestAllVoid(check, folders);
  TestFill(check);
  TestSingleValid(check);
  return check.GetResult();
}

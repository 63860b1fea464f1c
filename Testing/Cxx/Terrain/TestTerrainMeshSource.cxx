// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMeshSource promises a vertical error: in pixels for a camera, in metres for a region.
// Both are measured at many points of all triangles, in double precision, against the samples.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoSanitizer.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

namespace
{
// Measuring takes long with a sanitizer. Every fifth camera has a parallel projection.
constexpr int NumberOfCameras = RelevoHasAddressSanitizer ? 3 : 24;

// Square samples in a projected system: the map frame is easily inverted.
struct Terrain
{
  RelevoRaster Raster;
  double Spacing = 10.0;

  // Bilinear between the centres of samples; NaN without data.
  double GetHeight(double column, double row) const
  {
    const double x = std::clamp(column, 0.0, this->Raster.Width - 1.0);
    const double y = std::clamp(row, 0.0, this->Raster.Height - 1.0);
    const int i = std::min(static_cast<int>(x), this->Raster.Width - 2);
    const int j = std::min(static_cast<int>(y), this->Raster.Height - 2);
    double sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double weight = (corner % 2 ? x - i : 1.0 - x + i) * (corner / 2 ? y - j : 1.0 - y + j);
      const double sample = this->Raster.At(0, i + corner % 2, j + corner / 2);
      const bool isMissing = this->Raster.NoData && sample == *this->Raster.NoData;
      sum += weight > 0.0 ? weight * (isMissing ? std::numeric_limits<double>::quiet_NaN() : sample)
                          : 0.0;
    }
    return sum * this->Raster.Scale.value_or(1.0) + this->Raster.Offset.value_or(0.0);
  }

  double ToColumn(double x) const { return x / this->Spacing + 0.5 * (this->Raster.Width - 1.0); }
  double ToRow(double y) const { return -y / this->Spacing + 0.5 * (this->Raster.Height - 1.0); }
};

double GetRidges(double x, double y)
{
  double height = 0.0;
  double size = 400.0;
  for (double wave = 0.011; wave < 1.5; wave *= 2.1)
  {
    height += size * std::abs(std::sin(wave * x + 0.7 * std::cos(wave * y * 0.9)));
    size *= 0.45;
  }
  return height;
}

Terrain MakeTerrain(int width, int height, GDALDataType type)
{
  Terrain terrain;
  RelevoRaster& raster = terrain.Raster;
  raster.Width = width;
  raster.Height = height;
  raster.Type = type;
  const double d = terrain.Spacing;
  raster.Transform = { 500000.0, d, 0.0, 4200000.0, 0.0, -d };
  raster.CoordinateSystem = "EPSG:32633";
  raster.SetValues(
    [type](int, int column, int row)
    {
      const double h = GetRidges(column, row);
      return type == GDT_Int16 ? std::round(h) : static_cast<double>(static_cast<float>(h));
    });
  return terrain;
}

// Writes the file with overviews of means.
void WriteTerrain(
  RelevoCheck& check, const Terrain& terrain, const std::string& name, bool hasOverviews)
{
  terrain.Raster.Write(name);
  std::filesystem::remove(name + ".relevo-index");
  if (hasOverviews)
  {
    GDALDatasetH dataset = GDALOpen(name.c_str(), GA_Update);
    int levels[] = { 2, 4, 8, 16 };
    CHECK_EQUAL(
      GDALBuildOverviews(dataset, "AVERAGE", 4, levels, 0, nullptr, nullptr, nullptr), CE_None);
    GDALClose(dataset);
  }
}

// Calls the function with the position and the truth of points of triangles: all of a small mesh.
template <typename Function>
void ForPoints(vtkPolyData* mesh, const Terrain& terrain, Function function)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const vtkIdType step = 1 + mesh->GetNumberOfCells() / 50000;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); id += step)
  {
    vtkCell* cell = mesh->GetCell(id);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      cell->GetPoints()->GetPoint(i, p[i]);
    }
    for (int k = 0; k < 5; ++k)
    {
      double a = uniform(random);
      double b = uniform(random);
      a = k < 3 ? 0.5 : a;
      b = k == 0 ? 0.5 : k == 1 ? 0.0 : b;
      if (k == 2) // the middle of the third side
      {
        a = 0.0;
        b = 0.5;
      }
      if (a + b > 1.0)
      {
        a = 1.0 - a;
        b = 1.0 - b;
      }
      double q[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        q[axis] = p[0][axis] + a * (p[1][axis] - p[0][axis]) + b * (p[2][axis] - p[0][axis]);
      }
      function(q, terrain.GetHeight(terrain.ToColumn(q[0]), terrain.ToRow(q[1])));
    }
  }
}

// The largest error of a mesh in pixels for the camera, and how many points lack data.
double MeasurePixels(vtkPolyData* mesh, const Terrain& terrain, vtkCamera* camera,
  const int viewport[2], double exaggeration, int& missing)
{
  const double* eye = camera->GetPosition();
  const double factor = camera->GetParallelProjection()
    ? viewport[1] / (2.0 * camera->GetParallelScale())
    : viewport[1] / (2.0 * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0));
  double largest = 0.0;
  missing = 0;
  ForPoints(mesh, terrain,
    [&](const double q[3], double truth)
    {
      if (std::isnan(truth))
      {
        ++missing;
        return;
      }
      const double distance =
        camera->GetParallelProjection() ? 1.0 : std::sqrt(vtkMath::Distance2BetweenPoints(q, eye));
      largest = std::max(largest, std::abs(q[2] - exaggeration * truth) * factor / distance);
    });
  return largest;
}

// The area of a mesh on the map.
double MeasureArea(RelevoCheck& check, vtkPolyData* mesh)
{
  double area = 0.0;
  bool isUpward = true; // counter-clockwise seen from above
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    double a[3];
    double b[3];
    double c[3];
    vtkCell* cell = mesh->GetCell(id);
    cell->GetPoints()->GetPoint(0, a);
    cell->GetPoints()->GetPoint(1, b);
    cell->GetPoints()->GetPoint(2, c);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    isUpward = isUpward && twice > 0.0;
    area += twice / 2.0;
  }
  CHECK(isUpward);
  return area;
}

// The number of edges with one triangle that do not lie on the border of the rectangle.
int CountOpenEdges(vtkPolyData* mesh, const double bounds[4])
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->BoundaryEdgesOn();
  edges->ColoringOff();
  edges->Update();
  int open = 0;
  vtkPolyData* lines = edges->GetOutput();
  for (vtkIdType id = 0; id < lines->GetNumberOfCells(); ++id)
  {
    double box[6];
    lines->GetCellBounds(id, box);
    const auto isAt = [](double low, double high, double limit)
    { return std::abs(low - limit) < 1e-6 && std::abs(high - limit) < 1e-6; };
    open += isAt(box[0], box[1], bounds[0]) || isAt(box[0], box[1], bounds[1]) ||
        isAt(box[2], box[3], bounds[2]) || isAt(box[2], box[3], bounds[3])
      ? 0
      : 1;
  }
  return open;
}

void TestCameras(
  RelevoCheck& check, const RelevoTestFolders& folders, const Terrain& terrain, bool hasOverviews)
{
  const std::string name = folders.File(hasOverviews ? "mesh-overviews.tif" : "mesh-plain.tif");
  WriteTerrain(check, terrain, name, hasOverviews);
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  vtkNew<vtkTerrainMeshSource> source;
  source->SetPyramid(pyramid);
  vtkNew<vtkCamera> camera;
  source->SetCamera(camera);
  source->SetViewportSize(320, 200);
  const int viewport[2] = { 320, 200 };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double half = 0.5 * terrain.Spacing * terrain.Raster.Width;
  for (int i = 0; i < NumberOfCameras; ++i)
  {
    const double x = half * uniform(random);
    const double y = half * uniform(random);
    const double above = std::pow(10.0, 2.0 + uniform(random));
    const double ground = terrain.GetHeight(terrain.ToColumn(x), terrain.ToRow(y));
    const double exaggeration = i % 3 == 0 ? 2.0 : 1.0;
    const double z = exaggeration * (std::isnan(ground) ? 0.0 : ground) + above;
    camera->SetPosition(x, y, z);
    camera->SetFocalPoint(half * uniform(random), half * uniform(random), 300.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelProjection(i % 5 == 4);
    camera->SetParallelScale(half * (1.1 + uniform(random)));
    source->SetExaggeration(exaggeration);
    const double error = std::array<double, 3>{ { 0.5, 1.0, 2.0 } }[i % 3];
    source->SetScreenSpaceError(error);
    source->Update();
    int missing = 0;
    const double measured =
      MeasurePixels(source->GetOutput(), terrain, camera, viewport, exaggeration, missing);
    const std::string what = name + ", camera " + std::to_string(i) + ": error " +
      std::to_string(measured) + " of " + std::to_string(error) + ", in use " +
      std::to_string(source->GetScreenSpaceErrorInUse()) + ", " +
      std::to_string(source->GetOutput()->GetNumberOfCells()) + " triangles";
    std::cout << what << std::endl;
    CHECK_LESS_EQUAL(measured, error + 0.02);
    CHECK_LESS_EQUAL(measured, source->GetScreenSpaceErrorInUse() * 1.001 + 0.02);
    CHECK(terrain.Raster.NoData || missing == 0);
  }
  // From above, everything is seen.
  camera->SetParallelProjection(false);
  camera->SetPosition(0.0, 0.0, 12.0 * half);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  source->SetScreenSpaceError(0.5);
  source->SetExaggeration(1.0);
  source->Update();
  if (!terrain.Raster.NoData)
  {
    const double width = terrain.Spacing * (terrain.Raster.Width - 1.0);
    const double height = terrain.Spacing * (terrain.Raster.Height - 1.0);
    const double area = MeasureArea(check, source->GetOutput());
    CHECK_NEAR(area / (width * height), 1.0, 1e-9);
    const double bounds[4] = { -width / 2.0, width / 2.0, -height / 2.0, height / 2.0 };
    CHECK_EQUAL(CountOpenEdges(source->GetOutput(), bounds), 0);
  }
}

void TestRegions(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (const GDALDataType type : { GDT_Int16, GDT_Float32 })
  {
    const Terrain terrain = MakeTerrain(300, 211, type);
    const std::string name = folders.File("mesh-region.tif");
    WriteTerrain(check, terrain, name, false);
    vtkNew<vtkTerrainPyramid> pyramid;
    pyramid->SetFileName(name.c_str());
    vtkNew<vtkTerrainMeshSource> source;
    source->SetPyramid(pyramid);
    vtkIdType previous = std::numeric_limits<vtkIdType>::max();
    for (const double error : { 0.5, 3.0, 20.0, 100.0 })
    {
      source->SetMaximumError(error);
      source->Update();
      double largest = 0.0;
      ForPoints(source->GetOutput(), terrain,
        [&largest](const double q[3], double truth)
        { largest = std::max(largest, std::abs(q[2] - truth)); });
      const vtkIdType triangles = source->GetOutput()->GetNumberOfCells();
      const std::string what = "region, error " + std::to_string(largest) + " of " +
        std::to_string(error) + ", " + std::to_string(triangles) + " triangles";
      std::cout << what << "\n";
      CHECK_LESS_EQUAL(largest, error * 1.0001 + 1e-4);
      CHECK_LESS(triangles, previous);
      previous = triangles;
      const double width = terrain.Spacing * 299.0;
      const double height = terrain.Spacing * 210.0;
      const double bounds[4] = { -width / 2.0, width / 2.0, -height / 2.0, height / 2.0 };
      CHECK_NEAR(MeasureArea(check, source->GetOutput()) / (width * height), 1.0, 1e-9);
      CHECK_EQUAL(CountOpenEdges(source->GetOutput(), bounds), 0);
    }
    // A part, in coordinates of the raster.
    source->SetMaximumError(5.0);
    source->SetRegion(500502.0, 501003.0, 4199002.0, 4199503.0);
    source->Update();
    double bounds[6];
    source->GetOutput()->GetBounds(bounds);
    const double left = 500000.0 + 0.5 * 10.0 * 300.0;
    const double top = 4200000.0 - 0.5 * 10.0 * 211.0;
    const double low[2] = { bounds[0] + left, bounds[2] + top };
    const double high[2] = { bounds[1] + left, bounds[3] + top };
    CHECK(low[0] <= 500502.0 && low[0] > 500490.0 && high[0] >= 501003.0 && high[0] < 501015.0);
    CHECK(low[1] <= 4199002.0 && low[1] > 4198990.0 && high[1] >= 4199503.0 && high[1] < 4199515.0);
  }
}

void TestHole(RelevoCheck& check, const RelevoTestFolders& folders)
{
  Terrain terrain = MakeTerrain(129, 140, GDT_Int16);
  terrain.Raster.NoData = -9999.0;
  for (int row = 40; row < 61; ++row)
  {
    for (int column = 30; column < 75; ++column)
    {
      if ((column - 50) * (column - 50) + (row - 50) * (row - 50) < 100)
      {
        terrain.Raster.Values[row * 129 + column] = -9999.0;
      }
    }
  }
  const std::string name = folders.File("mesh-hole.tif");
  WriteTerrain(check, terrain, name, false);
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  vtkNew<vtkTerrainMeshSource> source;
  source->SetPyramid(pyramid);
  source->SetMaximumError(10.0);
  source->Update();
  int missing = 0;
  double largest = 0.0;
  ForPoints(source->GetOutput(), terrain,
    [&](const double q[3], double truth)
    {
      missing += std::isnan(truth) ? 1 : 0;
      largest = std::max(largest, std::isnan(truth) ? 0.0 : std::abs(q[2] - truth));
    });
  CHECK_EQUAL(missing, 0);
  CHECK_LESS_EQUAL(largest, 10.001);
  // All cells with four samples are there.
  int cells = 0;
  for (int row = 0; row + 1 < 140; ++row)
  {
    for (int column = 0; column + 1 < 129; ++column)
    {
      cells += std::isnan(terrain.GetHeight(column + 0.5, row + 0.5)) ? 0 : 1;
    }
  }
  CHECK_NEAR(MeasureArea(check, source->GetOutput()) / (100.0 * cells), 1.0, 1e-9);
}

void TestArrays(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const Terrain terrain = MakeTerrain(50, 40, GDT_Float32);
  const std::string name = folders.File("mesh-arrays.tif");
  WriteTerrain(check, terrain, name, false);
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  vtkNew<vtkTerrainMeshSource> source;
  source->SetPyramid(pyramid);
  source->SetMaximumError(2.0);
  source->SetExaggeration(3.0);
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  vtkDataArray* heights = mesh->GetPointData()->GetArray("Height");
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  CHECK(heights && coordinates && coordinates->GetNumberOfComponents() == 2);
  bool isRight = true;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    isRight = isRight && std::abs(p[2] - 3.0 * heights->GetTuple1(i)) < 1e-9 &&
      std::abs(coordinates->GetComponent(i, 0) - (p[0] / 500.0 + 0.5)) < 1e-6 &&
      std::abs(coordinates->GetComponent(i, 1) - (p[1] / 400.0 + 0.5)) < 1e-6;
  }
  CHECK(isRight);
  auto* origin = vtkDoubleArray::SafeDownCast(mesh->GetFieldData()->GetArray("Origin"));
  auto* system =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("CoordinateSystem"));
  CHECK(
    origin && origin->GetComponent(0, 0) == 500250.0 && origin->GetComponent(0, 1) == 4199800.0);
  CHECK(system && system->GetValue(0).find("UTM zone 33N") != std::string::npos);
}

// An image of the western half of the terrain: the texture has its colour there.
void TestImagery(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const Terrain terrain = MakeTerrain(50, 40, GDT_Int16);
  const std::string name = folders.File("mesh-imagery.tif");
  WriteTerrain(check, terrain, name, false);
  RelevoRaster image;
  image.Width = 50;
  image.Height = 80;
  image.NumberOfBands = 3;
  image.Type = GDT_Byte;
  image.Transform = { 500000.0, 5.0, 0.0, 4200000.0, 0.0, -5.0 };
  image.CoordinateSystem = "EPSG:32633";
  image.SetValues([](int band, int, int row) { return band == 1 ? 2.0 * row : 200.0; });
  const std::string imageName = folders.File("mesh-image.tif");
  CHECK(image.Write(imageName));
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  vtkNew<vtkTerrainMeshSource> source;
  source->SetPyramid(pyramid);
  source->SetMaximumError(20.0);
  source->Update();
  CHECK(source->GetImagery() == nullptr);
  source->SetImageryFileName(imageName.c_str());
  RelevoErrors errors(source);
  double lastProgress = 0.0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&lastProgress);
  observer->SetCallback([](vtkObject*, unsigned long, void* last, void* progress)
    { *static_cast<double*>(last) = *static_cast<double*>(progress); });
  source->AddObserver(vtkCommand::ProgressEvent, observer);
  source->Update();
  CHECK(lastProgress > 0.9 && lastProgress <= 1.0);
  CHECK_LESS_EQUAL(source->GetMaximumErrorInUse(), 20.0);
  CHECK_LESS(5.0, source->GetMaximumErrorInUse());
  vtkImageData* picture = source->GetImagery();
  const int* size = picture->GetDimensions();
  CHECK_EQUAL(size[0], 100);
  CHECK_EQUAL(size[1], 80);
  // Row 0 is in the south.
  CHECK_NEAR(picture->GetScalarComponentAsDouble(20, 0, 0, 1), 158.0, 2.0);
  CHECK_NEAR(picture->GetScalarComponentAsDouble(20, 79, 0, 1), 0.0, 2.0);
  CHECK_EQUAL(picture->GetScalarComponentAsDouble(20, 40, 0, 0), 200.0);
  CHECK_EQUAL(picture->GetScalarComponentAsDouble(80, 40, 0, 0), 128.0);
  source->SetImageryBands(2, 2, 2);
  source->SetMaximumImagerySize(10);
  source->Update();
  CHECK_EQUAL(source->GetImagery()->GetDimensions()[0], 10);
  CHECK_NEAR(source->GetImagery()->GetScalarComponentAsDouble(2, 0, 0, 0), 151.0, 4.0);
  source->SetImageryBands(1, 0, 2);
  CHECK(errors.Said("ImageryBands must be"));
  source->SetMaximumImagerySize(0);
  CHECK(errors.Said("MaximumImagerySize must be"));
  source->SetImageryBands(1, 2, 4);
  source->Update();
  CHECK(errors.Said("Cannot drape"));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 0);
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const auto checkError = [&check](vtkTerrainMeshSource* source, const char* words)
  {
    CHECK_CASE(words);
    RelevoErrors errors(source);
    source->Update();
    CHECK(errors.Said(words));
    CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 0);
  };
  vtkNew<vtkTerrainMeshSource> source;
  source->SetMaximumError(1.0);
  checkError(source, "SetPyramid()");
  vtkNew<vtkTerrainPyramid> pyramid;
  source->SetPyramid(pyramid);
  checkError(source, "SetFileName()");
  const Terrain terrain = MakeTerrain(20, 20, GDT_Int16);
  const std::string name = folders.File("mesh-errors.tif");
  WriteTerrain(check, terrain, name, false);
  pyramid->SetFileName(name.c_str());
  source->SetRegion(0.0, 1.0, 0.0, 1.0);
  checkError(source, "does not overlap");
  source->SetRegion(1.0, -1.0, 1.0, -1.0);
  source->SetMaximumError(1e-9);
  checkError(source, "too many triangles");
  source->SetMaximumError(0.0);
  checkError(source, "SetCamera()");
  RelevoRaster row = RelevoRaster::MakeSlope(30, 1, { 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 }, "");
  const std::string rowName = folders.File("mesh-row.tif");
  row.Write(rowName);
  pyramid->SetFileName(rowName.c_str());
  source->SetMaximumError(1.0);
  checkError(source, "one row or column");
  const RelevoRaster beyond =
    RelevoRaster::MakeSlope(30, 20, { 0.0, 1.0, 0.0, 95.0, 0.0, -1.0 }, "EPSG:4326");
  const std::string beyondName = folders.File("mesh-beyond.tif");
  CHECK(beyond.Write(beyondName));
  pyramid->SetFileName(beyondName.c_str());
  checkError(source, "beyond the poles");
  RelevoErrors errors(source);
  for (const double value : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    source->SetMaximumError(value);
    CHECK(errors.Said("MaximumError must be"));
    source->SetScreenSpaceError(value);
    CHECK(errors.Said("ScreenSpaceError must be"));
  }
  CHECK_EQUAL(source->GetMaximumError(), 1.0);
  source->SetViewportSize(0, 100);
  CHECK(errors.Said("ViewportSize must be"));
  source->SetMemoryLimit(-1);
  CHECK(errors.Said("MemoryLimit must be"));
}
}

int TestTerrainMeshSource(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestArrays(check, folders);
  TestImagery(check, folders);
  TestErrors(check, folders);
  TestRegions(check, folders);
  TestHole(check, folders);
  TestCameras(check, folders, MakeTerrain(700, 517, GDT_Int16), true);
  TestCameras(check, folders, MakeTerrain(300, 345, GDT_Float32), false);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The geocentric frame: positions against GeographicLib, bounds of boxes against points inside of
// them, and the error of meshes against the curved surface, in double precision.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoSanitizer.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/FaceHeights.h"
#include "Bisection/TerrainView.h"
#include "Geodesy/GlobeShape.h"
#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

namespace
{
constexpr int NumberOfCameras = RelevoHasAddressSanitizer ? 2 : 14;
constexpr int NumberOfBoxes = RelevoHasAddressSanitizer ? 600 : 3000;
constexpr int NumberOfSteps = RelevoHasAddressSanitizer ? 20 : 200;
constexpr double MoonRadius = 1737400.0;

using Point = std::array<double, 3>;

double GetDistance(const Point& a, const Point& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

// A raster, and the place of its samples.
struct Globe
{
  RelevoRaster Raster;
  double Axis = 6378137.0;
  double Flattening = 1.0 / 298.257223563;
  bool IsUTM = false; // zone 33 north

  void ToAngles(double column, double row, double& longitude, double& latitude) const
  {
    const auto& t = this->Raster.Transform;
    const double x = t[0] + (column + 0.5) * t[1];
    const double y = t[3] + (row + 0.5) * t[5];
    longitude = x;
    latitude = y;
    if (this->IsUTM)
    {
      GeographicLib::UTMUPS::Reverse(33, true, x, y, latitude, longitude);
    }
  }

  void ToSample(double longitude, double latitude, double& column, double& row) const
  {
    const auto& t = this->Raster.Transform;
    double x = longitude;
    double y = latitude;
    if (this->IsUTM)
    {
      int zone;
      bool isNorth;
      GeographicLib::UTMUPS::Forward(latitude, longitude, zone, isNorth, x, y, 33);
    }
    column = (x - t[0]) / t[1] - 0.5;
    row = (y - t[3]) / t[5] - 0.5;
    if (!this->IsUTM && std::abs(this->Raster.Width * t[1]) > 359.9)
    {
      column -= this->Raster.Width * std::floor(column / this->Raster.Width);
    }
  }

  // Bilinear between the centres of samples, closed at the antimeridian.
  double GetHeight(double longitude, double latitude) const
  {
    double column;
    double row;
    this->ToSample(longitude, latitude, column, row);
    const bool isClosed =
      !this->IsUTM && std::abs(this->Raster.Width * this->Raster.Transform[1]) > 359.9;
    const double x = isClosed ? column : std::clamp(column, 0.0, this->Raster.Width - 1.0);
    const double y = std::clamp(row, 0.0, this->Raster.Height - 1.0);
    const int i = static_cast<int>(x);
    const int j = std::min(static_cast<int>(y), this->Raster.Height - 2);
    double sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double weight = (corner % 2 ? x - i : 1.0 - x + i) * (corner / 2 ? y - j : 1.0 - y + j);
      int at = i + corner % 2;
      at = at < this->Raster.Width ? at : isClosed ? 0 : at - 1;
      sum += weight * this->Raster.At(0, at, j + corner / 2);
    }
    return sum;
  }

  GeographicLib::Geocentric GetEllipsoid() const { return { this->Axis, this->Flattening }; }

  Point ToWorld(double longitude, double latitude, double height) const
  {
    Point world;
    this->GetEllipsoid().Forward(latitude, longitude, height, world[0], world[1], world[2]);
    return world;
  }
};

Globe MakeGlobe(int width, int height, double left, double step, double top, double relief)
{
  Globe globe;
  globe.Raster.Width = width;
  globe.Raster.Height = height;
  globe.Raster.Type = GDT_Float32;
  globe.Raster.Transform = { left, step, 0.0, top, 0.0, -step };
  globe.Raster.CoordinateSystem = "EPSG:4326";
  globe.Raster.SetValues(
    [=](int, int column, int row)
    {
      // A function on the sphere, so that the seam is like all other columns.
      const double longitude = vtkMath::RadiansFromDegrees(left + (column + 0.5) * step);
      const double latitude = vtkMath::RadiansFromDegrees(top - (row + 0.5) * step);
      const double x = std::cos(latitude) * std::cos(longitude);
      const double y = std::cos(latitude) * std::sin(longitude);
      const double z = std::sin(latitude);
      double sum = 0.0;
      double size = 0.5 * relief;
      for (double wave = 3.0; wave < 3.0 / vtkMath::RadiansFromDegrees(step); wave *= 2.1)
      {
        sum += size * std::sin(wave * x + std::cos(wave * y)) * std::cos(0.8 * wave * z);
        size *= 0.5;
      }
      return static_cast<double>(static_cast<float>(sum));
    });
  return globe;
}

Globe MakeUTM()
{
  Globe globe;
  globe.IsUTM = true;
  RelevoRaster& raster = globe.Raster;
  raster.Width = 321;
  raster.Height = 243;
  raster.Type = GDT_Float32;
  raster.Transform = { 400000.0, 500.0, 0.0, 5400000.0, 0.0, -500.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.SetValues(
    [](int, int column, int row)
    {
      return static_cast<double>(
        static_cast<float>(700.0 * std::sin(0.05 * column) * std::cos(0.07 * row) +
          90.0 * std::sin(column + 0.6 * row)));
    });
  return globe;
}

Globe MakeMoon()
{
  Globe globe = MakeGlobe(180, 90, -180.0, 2.0, 90.0, 8000.0);
  globe.Axis = MoonRadius;
  globe.Flattening = 0.0;
  globe.Raster.CoordinateSystem =
    "GEOGCS[\"Moon\",DATUM[\"Moon\",SPHEROID[\"Moon\",1737400,0]],PRIMEM[\"Reference "
    "Meridian\",0],UNIT[\"degree\",0.0174532925199433]]";
  return globe;
}

std::shared_ptr<const relevo::HeightLattice> Open(
  RelevoCheck& check, const Globe& globe, const std::string& name, vtkTerrainPyramid* pyramid)
{
  globe.Raster.Write(name);
  std::filesystem::remove(name + ".relevo-index");
  pyramid->SetFileName(name.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  return pyramid->GetLattice();
}

void TestPositions(RelevoCheck& check, const relevo::GlobeShape& shape, const Globe& globe)
{
  CHECK_EQUAL(shape.GetFrame().GetError(), std::string());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double largest = 0.0;
  double slope = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    double column = uniform(random) * (globe.Raster.Width - 1.0);
    double row = 1.0 + uniform(random) * (globe.Raster.Height - 3.0);
    const double height = 9000.0 * uniform(random) - 1000.0;
    double longitude;
    double latitude;
    globe.ToAngles(column, row, longitude, latitude);
    relevo::GlobeShape::Vertex vertex;
    shape.Locate(1, &column, &row, &vertex);
    const Point truth = globe.ToWorld(longitude, latitude, height);
    largest = std::max(largest, GetDistance(vertex.ToWorld(height, 1.0), truth));
    // The derivatives undo a step of a hundredth of a sample.
    double next[2] = { column + 0.01, row };
    globe.ToAngles(next[0], next[1], longitude, latitude);
    const Point step = globe.ToWorld(longitude, latitude, 0.0);
    const double cosine = std::hypot(vertex.Up[0], vertex.Up[1]);
    const Point east = { { -vertex.Up[1] / cosine, vertex.Up[0] / cosine, 0.0 } };
    Point north;
    vtkMath::Cross(vertex.Up.data(), east.data(), north.data());
    Point difference;
    vtkMath::Subtract(step.data(), vertex.Position.data(), difference.data());
    const double toEast = vtkMath::Dot(difference.data(), east.data()) / cosine;
    const double toNorth = vtkMath::Dot(difference.data(), north.data());
    const auto& d = vertex.Derivatives;
    slope = std::max({ slope, std::abs(d[0] * toEast + d[2] * toNorth - 0.01),
      std::abs(d[1] * toEast + d[3] * toNorth) });
    const Point back = shape.GetFrame().ToGeographic(truth);
    CHECK_NEAR(back[2], height, 1e-6);
  }
  std::cout << "positions: " << largest << " m, derivatives: " << slope << "\n";
  CHECK_LESS(largest, 1e-4);
  CHECK_LESS(slope, 1e-4);
}

// Random boxes and points inside of them.
void TestBounds(RelevoCheck& check, const relevo::AdaptiveTerrain& terrain, const Globe& globe)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const relevo::TerrainPlacement placement = terrain.GetPlacement(1.0);
  const std::array<double, 2> end = placement.Globe->GetEnd();
  double tightest = 1.0;
  int hidden = 0;
  int visible = 0;
  for (int i = 0; i < NumberOfBoxes; ++i)
  {
    const double size = std::pow(0.5, 8.0 * uniform(random));
    relevo::TerrainBox box;
    const double column = uniform(random) * end[0] * (1.0 - size);
    const double row = uniform(random) * end[1] * (1.0 - size);
    box.Columns = { { column, column + size * end[0] } };
    box.Rows = { { row, row + size * end[1] } };
    box.Heights = { { 2000.0 * uniform(random), 2000.0 + 4000.0 * uniform(random) } };
    relevo::TerrainBox part = box;
    for (std::array<double, 2>* range : { &part.Columns, &part.Rows, &part.Heights })
    {
      const double length = (*range)[1] - (*range)[0];
      (*range)[1] -= 0.5 * length * uniform(random);
      (*range)[0] += 0.5 * length * uniform(random);
    }
    double longitude;
    double latitude;
    globe.ToAngles(uniform(random) * end[0], uniform(random) * end[1], longitude, latitude);
    const Point eye = globe.ToWorld(longitude, std::clamp(latitude, -90.0, 90.0),
      3000.0 + std::pow(10.0, 1.0 + 6.0 * uniform(random)));
    relevo::TerrainView view;
    view.SetPlacement(placement);
    view.SetPerspective(eye, 1.0, 0.0);
    const double bound = 1.0 / view.Project(1.0, box); // of the distance
    CHECK_LESS_EQUAL(bound, 1.0 / view.Project(1.0, part) * (1.0 + 1e-12));
    CHECK_LESS_EQUAL(view.GetShapeError(2, false, part), view.GetShapeError(2, false, box));
    double nearest = 1e300;
    for (int k = 0; k < 60; ++k)
    {
      const double x = box.Columns[0] + uniform(random) * (box.Columns[1] - box.Columns[0]);
      const double y = box.Rows[0] + uniform(random) * (box.Rows[1] - box.Rows[0]);
      const double h = box.Heights[0] + uniform(random) * (box.Heights[1] - box.Heights[0]);
      nearest = std::min(nearest, GetDistance(placement.ToWorld(x, y, h), eye));
    }
    CHECK_LESS_EQUAL(bound, nearest);
    tightest = std::min(tightest, 1.0 - bound / nearest);
    // A frustum that sees everything leaves the horizon.
    std::array<std::array<double, 4>, 6> planes{};
    for (auto& plane : planes)
    {
      plane[3] = 1.0;
    }
    view.SetFrustum(planes);
    if (view.IsVisible(box))
    {
      ++visible;
      continue;
    }
    ++hidden;
    // No line from the eye reaches a point without going below the ellipsoid of the lowest height.
    const double x = 0.5 * (box.Columns[0] + box.Columns[1]);
    const double y = 0.5 * (box.Rows[0] + box.Rows[1]);
    const Point target = placement.ToWorld(x, y, box.Heights[1]);
    double lowest = 1e300;
    for (int k = 1; k < 200; ++k)
    {
      Point on;
      for (int axis = 0; axis < 3; ++axis)
      {
        on[axis] = eye[axis] + k / 200.0 * (target[axis] - eye[axis]);
      }
      lowest = std::min(lowest, placement.Globe->GetFrame().ToGeographic(on)[2]);
    }
    CHECK_LESS(lowest, placement.LowestHeight + 1.0);
  }
  std::cout << "tightest distance: " << tightest << ", hidden " << hidden << ", visible " << visible
            << "\n";
  CHECK_LESS(tightest, 0.05);
  CHECK(placement.Globe->GetPeriod() == 0 || hidden > NumberOfBoxes / 30);
}

// The largest error of a mesh in pixels.
double MeasurePixels(
  vtkPolyData* mesh, const Globe& globe, vtkCamera* camera, int viewportHeight, double exaggeration)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const GeographicLib::Geocentric ellipsoid = globe.GetEllipsoid();
  const double factor = camera->GetParallelProjection()
    ? viewportHeight / (2.0 * camera->GetParallelScale())
    : viewportHeight / (2.0 * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0));
  Point eye;
  camera->GetPosition(eye.data());
  double largest = 0.0;
  const vtkIdType step = 1 + mesh->GetNumberOfCells() / 30000;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); id += step)
  {
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetCell(id)->GetPoints()->GetPoint(i, p[i]);
    }
    for (int k = 0; k < 5; ++k)
    {
      double a = k < 3 ? 0.5 : uniform(random);
      double b = k == 0 ? 0.5 : k == 1 ? 0.0 : uniform(random);
      if (k == 2)
      {
        a = 0.0;
        b = 0.5;
      }
      if (a + b > 1.0)
      {
        a = 1.0 - a;
        b = 1.0 - b;
      }
      Point q;
      for (int axis = 0; axis < 3; ++axis)
      {
        q[axis] = p[0][axis] + a * (p[1][axis] - p[0][axis]) + b * (p[2][axis] - p[0][axis]);
      }
      double longitude;
      double latitude;
      double height;
      ellipsoid.Reverse(q[0], q[1], q[2], latitude, longitude, height);
      double column;
      double row;
      globe.ToSample(longitude, latitude, column, row);
      if (row < 1.0 || row > globe.Raster.Height - 2.0) // the poles
      {
        continue;
      }
      const double distance = camera->GetParallelProjection() ? 1.0 : GetDistance(q, eye);
      const double truth = exaggeration * globe.GetHeight(longitude, latitude);
      largest = std::max(largest, std::abs(height - truth) * factor / distance);
    }
  }
  return largest;
}

void TestCameras(RelevoCheck& check, const Globe& globe, vtkTerrainPyramid* pyramid)
{
  vtkNew<vtkTerrainMeshSource> source;
  source->SetPyramid(pyramid);
  source->SetFrameToGeocentric();
  vtkNew<vtkCamera> camera;
  source->SetCamera(camera);
  source->SetViewportSize(320, 200);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < NumberOfCameras; ++i)
  {
    double longitude;
    double latitude;
    // Some cameras are at the seam, or near a pole.
    const double column =
      i % 4 == 1 ? globe.Raster.Width - 0.5 : uniform(random) * globe.Raster.Width;
    const double row =
      i % 7 == 2 ? globe.Raster.Height - 3.0 : uniform(random) * (globe.Raster.Height - 1.0);
    globe.ToAngles(column, row, longitude, latitude);
    const double exaggeration = i % 3 == 0 ? 2.0 : 1.0;
    const double ground = exaggeration * globe.GetHeight(longitude, latitude);
    const Point eye =
      globe.ToWorld(longitude, latitude, ground + std::pow(10.0, 1.0 + 6.0 * uniform(random)));
    const Point focus = globe.ToWorld(longitude + uniform(random) - 0.5,
      std::clamp(latitude + uniform(random) - 0.5, -90.0, 90.0), ground);
    const Point up = globe.ToWorld(longitude, latitude, 0.0);
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(focus.data());
    camera->SetViewUp(up.data());
    camera->SetParallelProjection(i % 5 == 4);
    camera->SetParallelScale(std::pow(10.0, 5.0 + uniform(random)));
    source->SetExaggeration(exaggeration);
    const double error = std::array<double, 3>{ { 0.5, 1.0, 2.0 } }[i % 3];
    source->SetScreenSpaceError(error);
    source->Update();
    const double measured = MeasurePixels(source->GetOutput(), globe, camera, 200, exaggeration);
    std::cout << "camera " << i << ": error " << measured << " of " << error << ", in use "
              << source->GetScreenSpaceErrorInUse() << ", "
              << source->GetOutput()->GetNumberOfCells() << " triangles" << std::endl;
    // Faces have a finest level.
    CHECK_LESS_EQUAL(measured, source->GetScreenSpaceErrorInUse() * 1.001 + 0.02);
  }
}

// The whole raster within a vertical tolerance.
void TestTolerance(RelevoCheck& check, const Globe& globe, vtkTerrainPyramid* pyramid)
{
  // A pixel of this camera is a metre.
  constexpr int viewportHeight = 100;
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * viewportHeight);
  vtkNew<vtkTerrainMeshSource> source;
  source->SetPyramid(pyramid);
  source->SetFrameToGeocentric();
  for (const double exaggeration : { 1.0, 2.0 })
  {
    const double error = globe.IsUTM ? 8.0 : 300.0;
    source->SetMaximumError(error);
    source->SetExaggeration(exaggeration);
    source->Update();
    vtkPolyData* mesh = source->GetOutput();
    const double measured = MeasurePixels(mesh, globe, camera, viewportHeight, exaggeration);
    std::cout << "tolerance " << error << " m: error " << measured << ", in use "
              << source->GetMaximumErrorInUse() << ", " << mesh->GetNumberOfCells()
              << " triangles\n";
    CHECK_LESS(10, mesh->GetNumberOfCells());
    CHECK_LESS_EQUAL(source->GetMaximumErrorInUse(), error);
    CHECK_LESS_EQUAL(measured, exaggeration * source->GetMaximumErrorInUse() + 1e-3);
    CHECK_LESS(0.2 * error, measured); // not much finer than necessary
    if (globe.Raster.Width * globe.Raster.Transform[1] == 360.0)
    {
      // There are no holes at the antimeridian and at the poles.
      vtkNew<vtkMassProperties> properties;
      properties->SetInputData(mesh);
      const double sphere = 4.0 * vtkMath::Pi() * globe.Axis * globe.Axis;
      CHECK_NEAR(properties->GetSurfaceArea() / sphere, 1.0, 0.015);
    }
  }
}
}

namespace
{
// The arithmetic of relevoTerrainGlobeVS.glsl and VTK's matrices, in floats, for an eye 2 m above
// the ground that moves in steps of 1 mm. Return the largest distance to positions in double
// precision, in pixels.
double MeasureJitter(relevo::AdaptiveTerrain& terrain, const Globe& globe)
{
  constexpr double pixelsPerUnit = 1000.0 / (2.0 * 0.2679); // 1000 pixels for 30 degrees
  const relevo::TerrainPlacement placement = terrain.GetPlacement(1.0);
  double longitude;
  double latitude;
  globe.ToAngles(100.3, 57.7, longitude, latitude);
  const double ground = globe.GetHeight(longitude, latitude);
  const Point start = globe.ToWorld(longitude, latitude, ground + 2.0);
  const Point target = globe.ToWorld(longitude + 1e-3, latitude + 1e-3, ground);
  relevo::TerrainView view;
  view.SetPlacement(placement);
  view.SetPerspective(start, pixelsPerUnit, 0.1);
  terrain.SelectAndWait(view, 1.0, [] { return false; });
  vtkNew<vtkCamera> camera;
  double largest = 0.0;
  int seen = 0;
  for (int step = 0; step < NumberOfSteps; ++step)
  {
    Point eye;
    std::array<float, 3> toOrigin; // part of the matrix
    Point origin;
    for (int axis = 0; axis < 3; ++axis)
    {
      eye[axis] = start[axis] + 1e-3 * step * (axis + 1.0) / 3.7;
      origin[axis] = std::round(eye[axis]);
      toOrigin[axis] = static_cast<float>(origin[axis] - eye[axis]);
    }
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(target.data());
    camera->SetViewUp(start.data());
    vtkMatrix4x4* rotation = camera->GetViewTransformMatrix();
    const float height = std::round(static_cast<float>(ground));
    for (std::size_t i = 0; i < terrain.GetFaces().size(); ++i)
    {
      const relevo::FaceHeights heights(terrain.GetFaces()[i]);
      const relevo::GlobeShape::Vertex& vertex = terrain.GetVertices()[i]->front();
      const float vertexHeight = heights.GetHeight(0, 0);
      const Point truth = vertex.ToWorld(vertexHeight, 1.0);
      const Point reference = vertex.ToWorld(height, 1.0);
      double exact[3] = { 0.0, 0.0, 0.0 };
      float rounded[3] = { 0.0f, 0.0f, 0.0f };
      for (int axis = 0; axis < 3; ++axis)
      {
        const float position = static_cast<float>(reference[axis] - origin[axis]) +
          (vertexHeight - height) * static_cast<float>(vertex.Up[axis]);
        for (int row = 0; row < 3; ++row)
        {
          const double element = rotation->GetElement(row, axis);
          exact[row] += element * (truth[axis] - eye[axis]);
          rounded[row] += static_cast<float>(element) * position;
          rounded[row] += static_cast<float>(element) * toOrigin[axis];
        }
      }
      const double depth = -exact[2];
      if (std::max(std::abs(exact[0]), std::abs(exact[1])) < 0.3 * depth) // in the window
      {
        ++seen;
        for (int row = 0; row < 2; ++row)
        {
          largest = std::max(
            largest, pixelsPerUnit * std::abs(exact[row] / exact[2] - rounded[row] / rounded[2]));
        }
      }
    }
  }
  std::cout << seen << " positions\n";
  return seen > 0 ? largest : std::numeric_limits<double>::infinity();
}
}

int TestTerrainGlobe(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::array<std::pair<const char*, Globe>, 5> globes = { {
    { "globe-rows.tif", MakeGlobe(720, 361, -180.25, 0.5, 90.25, 8000.0) },
    { "globe-centres.tif", MakeGlobe(720, 360, -180.0, 0.5, 90.0, 8000.0) },
    { "globe-region.tif", MakeGlobe(300, 200, 10.0, 0.01, 62.0, 1500.0) },
    { "globe-utm.tif", MakeUTM() },
    { "globe-moon.tif", MakeMoon() },
  } };
  for (const auto& [name, globe] : globes)
  {
    std::cout << name << "\n";
    vtkNew<vtkTerrainPyramid> pyramid;
    const auto lattice = Open(check, globe, folders.File(name), pyramid);
    relevo::AdaptiveTerrain terrain(lattice, nullptr, true);
    CHECK_EQUAL(terrain.FindLocationError(), std::string());
    TestPositions(check, *terrain.GetGlobe(), globe);
    TestBounds(check, terrain, globe);
    TestCameras(check, globe, pyramid);
    TestTolerance(check, globe, pyramid);
    const double jitter = MeasureJitter(terrain, globe);
    std::cout << "jitter: " << jitter << " pixels\n";
    CHECK_LESS(jitter, 0.1);
  }
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares the numbers of triangles that the level rules need for the same error on the screen.
#include "BenchmarkMeshes.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "Benchmarks.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Width = 1024;
constexpr int Height = 768;
constexpr int DenseLevel = 6;

struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkAdaptiveRefinement> Recipe;
  std::vector<vtkSmartPointer<vtkCamera>> Cameras;
};

vtkSmartPointer<vtkCamera> MakeCamera(
  const double position[3], const double focalPoint[3], const double up[3])
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(position);
  camera->SetFocalPoint(focalPoint);
  camera->SetViewUp(up);
  camera->SetClippingRange(0.01, 100.0);
  return camera;
}

// Displaced hills, seen from slightly above.
Scene MakeTerrain(int numberOfFaces)
{
  Scene scene{ "terrain", vtkSmartPointer<vtkPolyData>::New(),
    BenchmarkSurface::MakeDisplacedRecipe(), {} };
  BenchmarkSurface surface(numberOfFaces, 0.0);
  scene.Mesh->ShallowCopy(surface.GetMesh());
  scene.Mesh->GetPointData()->RemoveArray("DepthTag");
  const double up[3] = { 0.0, 0.0, 1.0 };
  for (const double x : { 0.3, 1.7, 2.8 })
  {
    const double position[3] = { x, 0.2, 0.4 };
    const double focalPoint[3] = { 2.0, 2.0, 0.0 };
    scene.Cameras.push_back(MakeCamera(position, focalPoint, up));
  }
  return scene;
}

// The bunny, coarsened, with PN triangles, from four sides; empty if the file is missing.
Scene MakeBunny(int numberOfFaces)
{
  Scene scene{ "bunny", nullptr, BenchmarkSurface::MakePNRecipe(), {} };
  const auto bunny = BenchmarkMeshes::ReadBunny();
  if (!bunny)
  {
    return scene;
  }
  scene.Mesh = BenchmarkMeshes::Decimate(bunny, numberOfFaces);
  const double length = scene.Mesh->GetLength();
  double center[3];
  scene.Mesh->GetCenter(center);
  const double up[3] = { 0.0, 1.0, 0.0 };
  for (const double angle : { 0.3, 1.9, 3.4, 5.0 })
  {
    const double position[3] = { center[0] + length * std::sin(angle), center[1] + 0.3 * length,
      center[2] + length * std::cos(angle) };
    scene.Cameras.push_back(MakeCamera(position, center, up));
  }
  return scene;
}

vtkSmartPointer<vtkPolyData> Refine(const Scene& scene, vtkCamera* camera)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(scene.Mesh);
  filter->SetRefinement(scene.Recipe);
  filter->SetCamera(camera);
  filter->SetViewportSize(Width, Height);
  filter->Update();
  return filter->GetOutput();
}

// In pixels. Returns false outside the picture.
bool Project(vtkMatrix4x4* matrix, const double point[3], double pixel[2])
{
  const double in[4] = { point[0], point[1], point[2], 1.0 };
  double out[4];
  matrix->MultiplyPoint(in, out);
  pixel[0] = 0.5 * Width * (out[0] / out[3] + 1.0);
  pixel[1] = 0.5 * Height * (out[1] / out[3] + 1.0);
  return out[3] > 0.0 && pixel[0] > 0.0 && pixel[0] < Width && pixel[1] > 0.0 && pixel[1] < Height;
}

struct Error
{
  double Triangles = 0.0;
  double Share95 = 0.0; // pixels: 95 % of the points in the picture have a smaller distance
  double Largest = 0.0;
};

// Distances of the true surface's points from the refined one, over all cameras.
Error Measure(const Scene& scene, vtkPolyData* truth)
{
  std::vector<double> distances;
  Error error;
  for (vtkCamera* camera : scene.Cameras)
  {
    const auto refined = Refine(scene, camera);
    error.Triangles += static_cast<double>(refined->GetNumberOfPolys());
    vtkNew<vtkStaticCellLocator> locator;
    locator->SetDataSet(refined);
    locator->BuildLocator();
    vtkMatrix4x4* matrix =
      camera->GetCompositeProjectionTransformMatrix(static_cast<double>(Width) / Height, -1.0, 1.0);
    const vtkIdType step = std::max<vtkIdType>(1, truth->GetNumberOfPoints() / 20000);
    for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); i += step)
    {
      double point[3];
      truth->GetPoint(i, point);
      double pixel[2];
      if (Project(matrix, point, pixel))
      {
        double nearest[3];
        vtkIdType cell;
        int subId;
        double distance2;
        locator->FindClosestPoint(point, nearest, cell, subId, distance2);
        double nearestPixel[2];
        Project(matrix, nearest, nearestPixel);
        distances.push_back(std::hypot(pixel[0] - nearestPixel[0], pixel[1] - nearestPixel[1]));
      }
    }
  }
  if (!distances.empty())
  {
    std::sort(distances.begin(), distances.end());
    error.Share95 = distances[(distances.size() - 1) * 95 / 100];
    error.Largest = distances.back();
  }
  return error;
}

// The number of triangles for an error, interpolated logarithmically between measurements; NaN
// outside them.
double GetTriangles(const std::vector<Error>& errors, double Error::*measure, double at)
{
  for (size_t i = 0; i + 1 < errors.size(); ++i)
  {
    const double a = errors[i].*measure;
    const double b = errors[i + 1].*measure;
    if (std::min(a, b) <= at && at <= std::max(a, b) && a != b)
    {
      const double t = std::log(at / a) / std::log(b / a);
      return errors[i].Triangles * std::pow(errors[i + 1].Triangles / errors[i].Triangles, t);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}
}

void RunRules(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("rules", "Triangles that rules take for the same error on the screen",
    { { "mesh", "mesh", 0 }, { "levels", "levels", 0 }, { "pixels", "reference, pixels", 1 },
      { "triangles", "triangles", 0 }, { "error_95", "error, 95 %, pixels", 3 },
      { "error_largest", "largest, pixels", 3 },
      { "ratio_95", "of per vertex, at the 95 % error", 2 },
      { "ratio_largest", "at the largest error", 2 } });
  struct Policy
  {
    const char* Name;
    int Rule;
    int Policy;
    int Measure;
  };
  const Policy ways[] = { { "per vertex", 0, 0, 0 }, { "per edge", 1, 0, 0 },
    { "per vertex, whole numbers", 0, 1, 0 }, { "per edge, whole numbers", 1, 1, 0 },
    { "per vertex, spheres", 0, 0, 1 }, { "per edge, spheres", 1, 0, 1 } };
  const std::vector<double> lengths = options.Quick
    ? std::vector<double>{ 40.0, 20.0 }
    : std::vector<double>{ 32.0, 22.6, 16.0, 11.3, 8.0, 5.7, 4.0 };
  for (Scene& scene : std::vector<Scene>{
         MakeTerrain(options.Quick ? 100 : 1000), MakeBunny(options.Quick ? 200 : 1500) })
  {
    if (!scene.Mesh)
    {
      table.AddNote("Without the bunny: RELEVO_TEST_DATA names no folder with mesh/bunny.ply.");
      continue;
    }
    scene.Recipe->GeomorphingOff();
    scene.Recipe->SetMaximumLevel(options.Quick ? 3 : DenseLevel);
    const auto truth = Refine(scene, nullptr);
    vtkNew<vtkScreenEdgeDepthTagMetric> metric;
    scene.Recipe->SetMetric(metric);
    std::vector<Error> reference;
    for (const Policy& way : ways)
    {
      scene.Recipe->SetLevelRule(way.Rule);
      scene.Recipe->SetSegmentPolicy(way.Policy);
      metric->SetMeasure(way.Measure);
      for (const double length : lengths)
      {
        metric->SetReferenceLength(length);
        const Error error = Measure(scene, truth);
        if (&way == ways)
        {
          reference.push_back(error);
        }
        const auto getRatio = [&](double Error::*measure) {
          return &way == ways ? 1.0
                              : error.Triangles / GetTriangles(reference, measure, error.*measure);
        };
        table.AddRow({ scene.Name, std::string(way.Name), length, error.Triangles, error.Share95,
          error.Largest, getRatio(&Error::Share95), getRatio(&Error::Largest) });
      }
    }
  }
  table.AddNote(
    "Triangles of all views together. Errors are distances on the screen, 1024 x 768, "
    "of points of the surface at full depth from the nearest of the refined one, without "
    "geomorphing. Ratios compare with the per-vertex rule in between its rows.");
  addTable(table);
}

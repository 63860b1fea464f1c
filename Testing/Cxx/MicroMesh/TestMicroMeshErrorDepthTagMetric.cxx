// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshErrorDepthTagMetric promises that refined triangles are within MaximumError, or
// ScreenSpaceError on the screen, of the surface at the highest level, with fewer triangles. Here
// distances are those to the nearest points, which VTK's locator finds.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkGenericCell.h"
#include "vtkMatrix4x4.h"
#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkMicroMeshSurface.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace RelevoMicroMeshes;

namespace
{
constexpr int HighestLevel = 4;
constexpr int Width = 640;
constexpr int Height = 480;
constexpr double Rounding = 1.001; // of floats

struct Scene
{
  Scene()
  {
    this->Recipe->SetSurface(vtkNew<vtkMicroMeshSurface>());
    this->Recipe->SetMetric(this->Metric);
    this->Recipe->SetMaximumLevel(HighestLevel);
    this->Filter->SetRefinement(this->Recipe);
    this->Filter->SetViewportSize(Width, Height);
  }

  Mesh Refine(vtkPolyData* micro)
  {
    this->Filter->SetInputData(micro);
    this->Filter->Update();
    const Mesh result = Mesh::New();
    result->DeepCopy(this->Filter->GetOutput());
    return result;
  }

  vtkNew<vtkMicroMeshErrorDepthTagMetric> Metric;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
};

// The largest distance on the screen from corners, middles of sides and centres of about 2500
// triangles of a mesh to the nearest points of another mesh.
double GetPixels(vtkPolyData* from, vtkPolyData* to, vtkCamera* camera)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(to);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> buffer;
  vtkMatrix4x4* matrix =
    camera->GetCompositeProjectionTransformMatrix(double(Width) / Height, -1.0, 1.0);
  const auto project = [matrix](const double x[3], double pixel[2])
  {
    const double point[4] = { x[0], x[1], x[2], 1.0 };
    double clip[4];
    matrix->MultiplyPoint(point, clip);
    pixel[0] = 0.5 * Width * clip[0] / clip[3];
    pixel[1] = 0.5 * Height * clip[1] / clip[3];
    return std::abs(pixel[0]) < 0.5 * Width && std::abs(pixel[1]) < 0.5 * Height && clip[3] > 0.0;
  };
  constexpr double shares[][3] = { { 1.0, 0.0, 0.0 }, { 0.5, 0.5, 0.0 }, { 0.0, 0.5, 0.5 },
    { 0.5, 0.0, 0.5 }, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } };
  double largest = 0.0;
  const vtkIdType step = from->GetNumberOfCells() / 2500 + 1;
  for (vtkIdType t = 0; t < from->GetNumberOfCells(); t += step)
  {
    vtkIdType size;
    const vtkIdType* ids;
    from->GetCellPoints(t, size, ids);
    for (const auto& share : shares)
    {
      double x[3] = { 0.0, 0.0, 0.0 };
      for (int corner = 0; corner < 3; ++corner)
      {
        double point[3];
        from->GetPoint(ids[corner], point);
        for (int c = 0; c < 3; ++c)
        {
          x[c] += share[corner] * point[c];
        }
      }
      double pixels[2][2];
      double nearest[3];
      double distance2;
      vtkIdType cell;
      int part;
      locator->FindClosestPoint(x, nearest, buffer, cell, part, distance2);
      if (project(x, pixels[0]) && project(nearest, pixels[1]))
      {
        largest =
          std::max(largest, std::hypot(pixels[0][0] - pixels[1][0], pixels[0][1] - pixels[1][1]));
      }
    }
  }
  return largest;
}

vtkIdType CountOpenEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

void CheckLevelErrors(RelevoCheck& check, const Mesh& micro, const Mesh& fine)
{
  vtkDataArray* errors = micro->GetCellData()->GetArray("MicroMeshLevelErrors");
  if (!CHECK(errors != nullptr) || !CHECK_EQUAL(errors->GetNumberOfComponents(), HighestLevel))
  {
    return;
  }
  for (int level = 0; level < HighestLevel; ++level)
  {
    CHECK_CASE(level);
    const double bound = errors->GetRange(level)[1];
    const Mesh mesh = Decode(micro, level);
    const double distance = std::max(GetDistance(mesh, fine), GetDistance(fine, mesh));
    CHECK_LESS_EQUAL(distance, bound * Rounding + 1e-6);
    CHECK_GREATER(distance, 0.2 * bound); // distances to the nearest points are not much smaller
  }
}

void CheckLengths(RelevoCheck& check, const Mesh& micro, const Mesh& fine)
{
  for (int rule : { vtkDepthTagMetric::PER_EDGE, vtkDepthTagMetric::PER_VERTEX })
  {
    CHECK_CASE(rule);
    vtkIdType triangles = fine->GetNumberOfCells();
    for (double error : { 0.002, 0.01 })
    {
      CHECK_CASE(error);
      Scene scene;
      scene.Recipe->SetLevelRule(rule);
      scene.Metric->SetMaximumError(error);
      const Mesh mesh = scene.Refine(micro);
      CHECK_LESS_EQUAL(GetDistance(mesh, fine), error * Rounding);
      CHECK_LESS_EQUAL(GetDistance(fine, mesh), error * Rounding);
      CHECK_EQUAL(CountOpenEdges(mesh), 0);
      CHECK_LESS(mesh->GetNumberOfCells(), 0.9 * static_cast<double>(triangles));
      CHECK_GREATER(mesh->GetNumberOfCells(), micro->GetNumberOfCells());
      triangles = mesh->GetNumberOfCells();
    }
  }
}

void CheckScreen(RelevoCheck& check, const Mesh& micro, const Mesh& fine)
{
  const auto compare = [&](const char* name, double distance, double pixels, Scene& scene)
  {
    CHECK_CASE(std::string(name));
    vtkNew<vtkCamera> camera;
    camera->SetPosition(0.4 * distance, -0.8 * distance, 0.45 * distance);
    camera->SetClippingRange(0.1, 100.0);
    scene.Filter->SetCamera(camera);
    scene.Metric->SetScreenSpaceError(pixels);
    const Mesh mesh = scene.Refine(micro);
    CHECK_LESS_EQUAL(GetPixels(mesh, fine, camera), pixels * Rounding);
    CHECK_LESS_EQUAL(GetPixels(fine, mesh, camera), pixels * Rounding);
    CHECK_EQUAL(CountOpenEdges(mesh), 0);
    return mesh->GetNumberOfCells();
  };
  Scene scene;
  CHECK_EQUAL(scene.Metric->GetScreenSpaceError(), 1.0);
  const vtkIdType far = compare("far", 12.0, 1.0, scene);
  const vtkIdType near = compare("near", 3.0, 1.0, scene);
  const vtkIdType rough = compare("rough", 3.0, 4.0, scene);
  CHECK_LESS(far, near);
  CHECK_LESS(rough, near);
  CHECK_LESS(near, fine->GetNumberOfCells());
  scene.Recipe->SetLevelRuleToPerEdge();
  CHECK_LESS(compare("per edge", 3.0, 1.0, scene), near);
  scene.Recipe->GeomorphingOn();
  compare("geomorphing", 3.0, 1.0, scene);
  compare("geomorphing, rough", 3.0, 3.0, scene);
  scene.Recipe->GeomorphingOff();
  scene.Recipe->SetSegmentPolicyToWholeNumbers();
  compare("whole numbers", 3.0, 1.0, scene);
}

// Without the stored errors, the metric computes them.
void CheckWithoutErrors(RelevoCheck& check, const Mesh& micro)
{
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(micro);
  bare->GetCellData()->RemoveArray("MicroMeshLevelErrors");
  Scene scene;
  scene.Metric->SetMaximumError(0.004);
  const vtkIdType cells = scene.Refine(micro)->GetNumberOfCells();
  CHECK_EQUAL(scene.Refine(bare)->GetNumberOfCells(), cells);
}

void CheckErrors(RelevoCheck& check, const Mesh& micro)
{
  Scene scene;
  RelevoErrors filterErrors(scene.Filter);
  RelevoErrors errors(scene.Metric);
  scene.Refine(micro);
  CHECK(errors.Said("camera"));
  scene.Metric->SetMaximumError(0.1);
  scene.Recipe->SetSurface(nullptr);
  CHECK_EQUAL(scene.Refine(Plate(4))->GetNumberOfCells(), 0);
  CHECK(errors.Said("the mesh is not a micro-mesh"));
  for (double bad : { 0.0, -1.0, 1e7, std::nan("") })
  {
    CHECK_CASE(bad);
    scene.Metric->SetScreenSpaceError(bad);
    CHECK(errors.Said("ScreenSpaceError must be in [0.001, 1e+06]"));
  }
  scene.Metric->SetMaximumError(-1.0);
  CHECK(errors.Said("MaximumError must be"));
  CHECK_EQUAL(scene.Metric->GetMaximumError(), 0.1);
}
}

int TestMicroMeshErrorDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  const Mesh micro = Encode(ReliefSphere(40, 24), 0.004, HighestLevel, 0.95);
  const Mesh fine = Decode(micro, HighestLevel);
  CheckLevelErrors(check, micro, fine);
  CheckLengths(check, micro, fine);
  CheckScreen(check, micro, fine);
  CheckWithoutErrors(check, micro);
  CheckErrors(check, micro);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves flow.md: on a mesh refined where the vectors turn, vtkSurfaceLineIntegralConvolution is
// closer to the result on a dense mesh than on the coarse mesh or on more triangles of equal size.
#include "RelevoCheck.h"
#include "RelevoSurfaceLIC.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellLocator.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"

#include <iostream>

namespace
{
using namespace RelevoVectors;

constexpr int MaximumLevel = 3;

// The field runs along the torus. In one region it turns through all directions in waves.
Vector Swirl(const Vector& p)
{
  const double u = std::atan2(p[1], p[0]);
  const double v = std::atan2(p[2], std::hypot(p[0], p[1]) - 1.0);
  const Vector alongU{ { -std::sin(u), std::cos(u), 0 } };
  const Vector alongV{ { -std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v) } };
  const double angle =
    0.3 + 6.0 * std::exp((u * u + v * v) / -0.3) * std::sin(8 * v) * std::cos(8 * u);
  return std::cos(angle) * alongU + std::sin(angle) * alongV;
}

RelevoMeshes::Mesh CoarseTorus()
{
  auto torus = RelevoMeshes::Torus(40, 24);
  torus->SetVerts(nullptr); // the vertices of collapsed triangles
  torus->SetLines(nullptr);
  AddVelocity(torus, Swirl);
  return torus;
}

vtkSmartPointer<vtkFieldVariationDepthTagMetric> MakeVariation()
{
  auto metric = vtkSmartPointer<vtkFieldVariationDepthTagMetric>::New();
  metric->SetArrayName("Velocity");
  metric->SetMaximumVariation(0.15);
  return metric;
}

// Evaluates the field at every point, as a simulation or a formula would.
RelevoMeshes::Mesh Convolve(vtkPolyData* surface)
{
  auto mesh = RelevoMeshes::Make();
  mesh->ShallowCopy(surface);
  AddVelocity(mesh, Swirl);
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetInputData(mesh);
  filter->SetGrainSize(0.5);
  filter->SetStepSize(0.05);
  filter->Update();
  mesh->ShallowCopy(filter->GetOutput());
  return mesh;
}

// Distance of a mesh's interpolated LIC from that of the dense mesh, relative to the dense mesh's
// contrast.
double FindError(vtkPolyData* mesh, vtkPolyData* dense)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  vtkDataArray* lic = mesh->GetPointData()->GetArray("LIC");
  vtkDataArray* expected = dense->GetPointData()->GetArray("LIC");
  double difference = 0.0;
  double contrast = 0.0;
  for (vtkIdType point = 0; point < dense->GetNumberOfPoints(); point += 5)
  {
    double x[3];
    double closest[3];
    double squared;
    vtkIdType id;
    int part;
    double parameters[3];
    double weights[3];
    dense->GetPoint(point, x);
    locator->FindClosestPoint(x, closest, cell, id, part, squared);
    cell->EvaluatePosition(closest, nullptr, part, parameters, squared, weights);
    double value = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      value += weights[i] * lic->GetComponent(cell->GetPointId(i), 0);
    }
    const double there = expected->GetComponent(point, 0);
    difference += (value - there) * (value - there);
    contrast += (there - 0.5) * (there - 0.5);
  }
  return std::sqrt(difference / contrast);
}

void CheckCloser(RelevoCheck& check)
{
  auto torus = CoarseTorus();
  vtkNew<vtkPNTriangleSurface> surface;
  const auto refine = [&](int level, vtkDepthTagMetric* metric)
  {
    auto recipe = RelevoMeshes::MakeRecipe(level, surface);
    recipe->SetMetric(metric);
    return Convolve(RelevoMeshes::Refine(torus, recipe));
  };
  auto dense = refine(MaximumLevel, nullptr);
  auto coarse = Convolve(torus);
  auto adaptive = refine(MaximumLevel, MakeVariation());
  auto uniform = refine(MaximumLevel - 1, nullptr);
  const double ofCoarse = FindError(coarse, dense);
  const double ofAdaptive = FindError(adaptive, dense);
  const double ofUniform = FindError(uniform, dense);
  std::cout << "coarse, " << coarse->GetNumberOfCells() << " triangles: error " << ofCoarse
            << "\nadaptive, " << adaptive->GetNumberOfCells() << ": " << ofAdaptive << "\nuniform, "
            << uniform->GetNumberOfCells() << ": " << ofUniform << "\ndense, "
            << dense->GetNumberOfCells() << "\n";
  CHECK_LESS(FindError(dense, dense), 1e-6);
  CHECK_LESS(adaptive->GetNumberOfCells(), uniform->GetNumberOfCells());
  CHECK_LESS(ofAdaptive, 0.1 * ofCoarse);
  CHECK_LESS(ofAdaptive, 0.5 * ofUniform);
}

// A recipe combines field variation, a region of interest and a limit of 10 pixels for edges.
void CheckRecipe(RelevoCheck& check)
{
  auto torus = CoarseTorus();
  vtkNew<vtkCompositeDepthTagMetric> metric;
  metric->AddMetric(MakeVariation());
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetCenter(-1.5, 0, 0); // opposite to the swirl
  region->SetRadius(0.4);
  region->SetFallOff(0.3);
  metric->AddMetric(region);
  vtkNew<vtkScreenEdgeDepthTagMetric> screen;
  metric->AddMetric(screen);
  vtkNew<vtkPNTriangleSurface> surface;
  auto recipe = RelevoMeshes::MakeRecipe(MaximumLevel, surface);
  recipe->SetMetric(metric);
  recipe->GeomorphingOff(); // all segments of an edge have the same length
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 6);
  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputData(torus);
  refine->SetRefinement(recipe);
  refine->SetCamera(camera);
  refine->SetViewportSize(200, 200);
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetInputConnection(refine->GetOutputPort());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  filter->SetGrainSize(0.5);
  filter->SetStepSize(0.05);
  filter->SetNumberOfSteps(3);
  filter->Update();
  CHECK(RelevoSurfaceLIC(filter->GetOutput()).IsValid());
  // Measures the longest flat edge on the screen for a view angle of 30 degrees, and counts
  // triangles in the two regions of interest.
  const double pixels = 100.0 / std::tan(vtkMath::RadiansFromDegrees(15.0));
  double longest = 0.0;
  double longestInRegion = 0.0;
  vtkPolyData* output = filter->GetOutput();
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    output->GetCellPoints(i, points);
    for (int side = 0; side < 3; ++side)
    {
      Vector a;
      Vector b;
      output->GetPoint(points->GetId(side), a.data());
      output->GetPoint(points->GetId((side + 1) % 3), b.data());
      const auto project = [=](const Vector& p) {
        return pixels / (6.0 - p[2]) * Vector{ { p[0], p[1], 0 } };
      };
      longest = std::max(longest, length(project(b) - project(a)));
      if (length(a - Vector{ { -1.5, 0, 0 } }) < 0.1)
      {
        longestInRegion = std::max(longestInRegion, length(b - a));
      }
    }
  }
  std::cout << output->GetNumberOfCells() << " triangles, edges of at most " << longest
            << " pixels, " << longestInRegion << " in the region\n";
  // Levels per point allow a factor of sqrt(2), and the curved surface lengthens edges slightly.
  CHECK_LESS(longest, 10.0 * std::sqrt(2.0) * 1.1);
  CHECK_GREATER(longestInRegion, 0.0);
  CHECK_LESS(longestInRegion, 0.35 / 8);
}
}

int TestSurfaceLineIntegralConvolutionRefined(int, char*[])
{
  RelevoCheck check;
  CheckCloser(check);
  CheckRecipe(check);
  return check.GetResult();
}

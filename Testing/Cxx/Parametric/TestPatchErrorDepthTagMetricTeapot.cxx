// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves patches.md: within half a pixel, the Utah teapot needs fewer triangles than with uniformly
// split cells.
#include "RelevoCheck.h"
#include "RelevoPatchDistance.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkBezierPatchReader.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

namespace
{
constexpr double Pixels = 0.5;

// Number of triangles at the lowest sufficient level of vtkDataSetSurfaceFilter, which splits a
// bicubic cell into 3 * 2^level parts per direction. The deviation is not measured on its
// triangles, because those at collapsed borders deviate at levels where all others are sufficient.
vtkIdType CountEvenTriangles(const RelevoPatchDistance& distance, vtkCamera* camera, int height)
{
  for (int parts = 3; parts < 1000; parts *= 2)
  {
    const vtkSmartPointer<vtkPolyData> even = distance.Cut(parts);
    const vtkIdType triangles = even->GetNumberOfPolys();
    const int stride = static_cast<int>(triangles / 4000) | 1;
    if (distance.MeasurePixels(even, camera, height, stride) <= Pixels)
    {
      return triangles;
    }
  }
  return 0;
}

// Triangles of coarse faces that reach into the square viewport; others are culled.
vtkIdType CountSeenTriangles(vtkPolyData* refined, vtkCamera* camera)
{
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0);
  vtkDataArray* faces = refined->GetCellData()->GetArray("vtkOriginalCellIds");
  std::map<int, vtkIdType> counts;
  std::set<int> seen;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfPolys(); ++cell)
  {
    const int face = static_cast<int>(faces->GetComponent(cell, 0));
    ++counts[face];
    refined->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType id : *ids)
    {
      double x[4] = { 0.0, 0.0, 0.0, 1.0 };
      refined->GetPoint(id, x);
      matrix->MultiplyPoint(x, x);
      if (std::abs(x[0]) <= x[3] && std::abs(x[1]) <= x[3])
      {
        seen.insert(face);
      }
    }
  }
  vtkIdType triangles = 0;
  for (int face : seen)
  {
    triangles += counts[face];
  }
  return triangles;
}

// Geometric mean of the ratios of triangles.
double CompareWindows(
  RelevoCheck& check, vtkPolyData* coarse, vtkCamera* camera, const RelevoPatchDistance& distance)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  vtkNew<vtkPatchErrorDepthTagMetric> metric;
  metric->SetScreenSpaceError(Pixels);
  recipe->SetMetric(metric);
  recipe->SetLevelRuleToPerEdge();
  recipe->SetMaximumLevel(7);
  recipe->SetSegmentPolicyToWholeNumbers();
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(coarse);
  filter->SetRefinement(recipe);
  filter->SetCamera(camera);
  double logarithms = 0.0;
  int windows = 0;
  for (int width = 256; width <= 2048; width *= 2, ++windows)
  {
    filter->SetViewportSize(width, width);
    filter->Update();
    const auto triangles = static_cast<double>(CountSeenTriangles(filter->GetOutput(), camera));
    const int stride = static_cast<int>(filter->GetOutput()->GetNumberOfPolys() / 8000) | 1;
    const double error = distance.MeasurePixels(filter->GetOutput(), camera, width, stride);
    const auto even = static_cast<double>(CountEvenTriangles(distance, camera, width));
    std::cout << width << " pixels: " << triangles << " triangles, error " << error
              << " pixels; uniform " << even << ", ratio " << triangles / even << "\n";
    CHECK_LESS_EQUAL(error, Pixels);
    CHECK_GREATER(error, 0.1 * Pixels);
    logarithms += std::log(triangles / even);
  }
  return std::exp(logarithms / windows);
}
}

int TestPatchErrorDepthTagMetricTeapot(int, char*[])
{
  RelevoCheck check;
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string name = std::string(data ? data : "") + "/mesh/teapot.bpt";
  if (!std::ifstream(name))
  {
    std::cerr << "RELEVO_TEST_DATA has no mesh/teapot.bpt: skipped\n";
    return 125;
  }
  vtkNew<vtkBezierPatchReader> reader;
  reader->SetFileName(name.c_str());
  vtkNew<vtkPatchSurfaceFilter> patches;
  patches->SetInputConnection(reader->GetOutputPort());
  patches->SplitPatchesOn();
  patches->Update();
  vtkPolyData* coarse = patches->GetOutput();
  vtkNew<vtkCamera> camera;
  RelevoLookAt(coarse, camera);
  const RelevoPatchDistance distance(coarse);
  const double whole = CompareWindows(check, coarse, camera, distance);
  std::cout << "geometric mean " << whole << "\n";
  CHECK_LESS(whole, 0.6);
  camera->Zoom(10.0);
  const double part = CompareWindows(check, coarse, camera, distance);
  std::cout << "geometric mean at tenfold zoom " << part << "\n";
  CHECK_LESS(part, 0.15);
  return check.GetResult();
}

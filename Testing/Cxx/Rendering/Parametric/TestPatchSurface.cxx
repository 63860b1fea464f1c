// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurface promises points and normals of the patch itself, also at poles. They are compared
// with the binomial formula and with round shapes. Closed surfaces stay closed bit for bit, with
// and without displacement.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoLeaks.h"
#include "RelevoPatchMeshes.h"
#include "RelevoPatches.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptivePatchMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPatchSurface.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace RelevoMeshes;

namespace
{
Mesh RefinePatches(
  RelevoCheck& check, vtkPolyData* patches, int level, vtkDisplacement* displacement = nullptr)
{
  vtkNew<vtkPatchSurface> surface;
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(MakeRecipe(level, surface, displacement));
  filter->SetInputData(patches);
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.None());
  return filter->GetOutput();
}

// Compares each point and normal with the binomial formula, at parameters that Lagrange cells
// interpolate.
void TestPlaces(RelevoCheck& check, int type, const std::array<int, 3>& degrees)
{
  auto grid = RelevoNewCell(type, degrees, 0.2 / std::max(degrees[0], degrees[1]));
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetName("Parameters");
  parameters->SetNumberOfComponents(2);
  const double* nodes = grid->GetCell(0)->GetParametricCoords();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    parameters->InsertNextTuple2(nodes[3 * i], nodes[3 * i + 1]);
  }
  grid->GetPointData()->AddArray(parameters);
  auto patches = RelevoMakePatches(grid);
  const Mesh refined = RefinePatches(check, patches, 3);
  vtkDataArray* at = refined->GetPointData()->GetArray("Parameters");
  vtkDataArray* normals = refined->GetPointData()->GetNormals();
  double worst = 0.0;
  double turned = 0.0;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const double u = at->GetComponent(i, 0);
    const double v = at->GetComponent(i, 1);
    const auto evaluate = [&](double a, double b) { return RelevoEvaluatePatch(patches, 0, a, b); };
    const std::vector<double> place = evaluate(u, v);
    double byU[3];
    double byV[3];
    constexpr double step = 1e-5;
    const std::vector<double> right = evaluate(u + step, v);
    const std::vector<double> left = evaluate(u - step, v);
    const std::vector<double> above = evaluate(u, v + step);
    const std::vector<double> below = evaluate(u, v - step);
    for (int c = 0; c < 3; ++c)
    {
      worst = std::max(worst, std::abs(refined->GetPoint(i)[c] - place[c]));
      byU[c] = right[c] - left[c];
      byV[c] = above[c] - below[c];
    }
    double expected[3];
    vtkMath::Cross(byU, byV, expected);
    vtkMath::Normalize(expected);
    double normal[3];
    normals->GetTuple(i, normal);
    turned = std::max(turned, std::sqrt(vtkMath::Distance2BetweenPoints(expected, normal)));
  }
  if (worst > 2e-6 || turned > 2e-4)
  {
    std::cerr << "type " << type << ", degrees " << degrees[0] << " and " << degrees[1] << ": "
              << worst << ", normals " << turned << "\n";
  }
  CHECK_GREATER(refined->GetNumberOfPoints(), 40);
  CHECK_LESS_EQUAL(worst, 2e-6);
  CHECK_LESS_EQUAL(turned, 2e-4);
}

// Largest deviations of points and normals from a torus, or from a sphere if `radius` is 0.
void TestRound(RelevoCheck& check, vtkPolyData* patches, double radius, double tube)
{
  const Mesh refined = RefinePatches(check, patches, 4);
  vtkDataArray* normals = refined->GetPointData()->GetNormals();
  CHECK_GREATER(refined->GetNumberOfPoints(), 500);
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    double x[3];
    refined->GetPoint(i, x);
    const double distance = std::hypot(x[0], x[1]);
    const double factor = distance > 0.0 ? 1.0 - radius / distance : 0.0;
    const double across[3] = { x[0] * factor, x[1] * factor, x[2] };
    CHECK_NEAR(vtkMath::Norm(across), tube, 1e-6);
    double normal[3];
    normals->GetTuple(i, normal);
    CHECK_NEAR(vtkMath::Dot(across, normal) / tube, 1.0, 1e-5);
  }
}

void TestClosed(RelevoCheck& check, const std::string& name, vtkPolyData* patches)
{
  auto tagged = vtk::TakeSmartPointer(patches->NewInstance());
  tagged->ShallowCopy(patches);
  const Mesh mesh = Tagged(tagged, 4);
  auto displacement = MakeDisplacement(nullptr, 1.0, 0.1);
  for (vtkDisplacement* used : { static_cast<vtkDisplacement*>(nullptr), displacement.Get() })
  {
    const bool isClosed = RelevoLeaks::IsClosed(RefinePatches(check, mesh, 4, used));
    if (!isClosed)
    {
      std::cerr << name << (used ? ", displaced" : "") << "\n";
    }
    CHECK(isClosed);
  }
}

// The bounds of the mapper contain all points, with and without displacement.
void TestBounds(RelevoCheck& check, vtkPolyData* patches)
{
  auto displacement = MakeDisplacement(nullptr, 1.0, 0.1);
  for (vtkDisplacement* used : { static_cast<vtkDisplacement*>(nullptr), displacement.Get() })
  {
    const Mesh refined = RefinePatches(check, patches, 4, used);
    vtkBoundingBox box(refined->GetBounds());
    vtkNew<vtkAdaptivePatchMapper> mapper;
    mapper->SetInputData(patches);
    mapper->GetRefinement()->SetDisplacement(used);
    vtkBoundingBox told(mapper->GetBounds());
    CHECK_LESS(told.GetMaxLength(), 2.0 * box.GetMaxLength());
    told.Inflate(1e-6);
    CHECK_EQUAL(told.Contains(box), 1);
  }
}
}

int TestPatchSurface(int, char*[])
{
  RelevoCheck check;
  for (int p = 1; p <= 8; ++p)
  {
    TestPlaces(check, VTK_LAGRANGE_QUADRILATERAL, { { p, 9 - p, 0 } });
    TestPlaces(check, VTK_LAGRANGE_TRIANGLE, { { p, p, 0 } });
  }
  auto torus = RelevoNewPatchTorus();
  auto sphere = RelevoNewPatchSphere();
  auto cube = RelevoNewPatchCube();
  TestRound(check, torus, 2.0, 0.5);
  TestRound(check, sphere, 0.0, 1.0);
  TestClosed(check, "torus", torus);
  TestClosed(check, "sphere", sphere);
  TestClosed(check, "cube", cube);
  TestBounds(check, torus);
  TestBounds(check, cube);
  return check.GetResult();
}

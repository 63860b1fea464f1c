// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves intersections.md: curved, displaced surfaces are refined where they can intersect. Results
// are compared with vtkAdaptiveRefinementFilter, and curves with the exact surfaces.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoIntersections.h"
#include "RelevoTestMeshes.h"
#include "RelevoWarnings.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkRefinedCellLocator.h"
#include "vtkSurfaceIntersectionFilter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
using namespace RelevoMeshes;

constexpr double Scale = 0.7; // scale of the sphere

// A torus, and a sphere with waves inside its tube. Both are curved.
struct Scene
{
  explicit Scene(int level, bool hasHoles = false)
  {
    vtkNew<vtkPNTriangleSurface> surface;
    vtkNew<RelevoHeights> heights;
    // Heights are equal on both sides of the seam and around the poles.
    heights->Fill(64, 64,
      [](double u, double v)
      {
        const double pi = vtkMath::Pi();
        return std::cos(6 * pi * u) * std::pow(std::sin(pi * v), 2) * std::cos(4 * pi * v);
      });
    if (hasHoles)
    {
      heights->Punch([](int x, int y) { return x % 16 < 2 && y > 20 && y < 40; });
    }
    this->Meshes[0] = Torus();
    this->Recipes[0] = MakeRecipe(level, surface);
    this->Meshes[1] = TexturedSphere(20, 12);
    this->Recipes[1] = MakeRecipe(level, surface, MakeDisplacement(heights, 0.1));
    this->Matrix = RelevoMakeMotion({ 1.4, 0.1, 0.15 }, 30, { 1, 2, 3 }, Scale);
  }

  vtkSmartPointer<vtkSurfaceIntersectionFilter> NewFilter() const
  {
    auto filter = vtkSmartPointer<vtkSurfaceIntersectionFilter>::New();
    for (int i = 0; i < 2; ++i)
    {
      filter->SetInputData(i, this->Meshes[i]);
      filter->SetRefinement(i, this->Recipes[i]);
    }
    filter->SetMatrix(1, this->Matrix);
    return filter;
  }

  Mesh Meshes[2];
  vtkSmartPointer<vtkAdaptiveRefinement> Recipes[2];
  vtkSmartPointer<vtkMatrix4x4> Matrix;
};

vtkIdType GetId(vtkPolyData* mesh, const char* array, vtkIdType cell)
{
  return static_cast<vtkIdType>(mesh->GetCellData()->GetArray(array)->GetComponent(cell, 0));
}

// Pairs of coarse cells that intersect, by the curves or overlaps of refined meshes.
std::set<std::pair<vtkIdType, vtkIdType>> GetCoarsePairs(
  vtkPolyData* curves, vtkPolyData* first, vtkPolyData* second)
{
  std::set<std::pair<vtkIdType, vtkIdType>> pairs;
  for (const auto& [i, j] : RelevoGetCellPairs(curves))
  {
    const std::pair<vtkIdType, vtkIdType> cells(
      GetId(first, "vtkOriginalCellIds", i), GetId(second, "vtkOriginalCellIds", j));
    pairs.insert(first == second
        ? std::pair<vtkIdType, vtkIdType>(std::minmax(cells.first, cells.second))
        : cells);
  }
  return pairs;
}

// With all levels at the maximum, the meshes equal those of vtkAdaptiveRefinementFilter.
void TestTwin(RelevoCheck& check, bool hasHoles)
{
  const Scene scene(3, hasHoles);
  auto filter = scene.NewFilter();
  filter->Update();
  Mesh refined[2];
  vtkNew<vtkSurfaceIntersectionFilter> reference;
  for (int i = 0; i < 2; ++i)
  {
    refined[i] = Refine(scene.Meshes[i], scene.Recipes[i]);
    reference->SetInputData(i, refined[i]);
  }
  CHECK_LESS(filter->GetRefinedSurface(0)->GetNumberOfPolys(), refined[0]->GetNumberOfPolys() / 2);
  reference->SetMatrix(1, scene.Matrix);
  RelevoErrors errors(reference); // triangles without area give a warning
  reference->Update();
  const double length = RelevoMeasureLength(reference->GetOutput());
  CHECK_GREATER(length, 1.0);
  CHECK_NEAR(RelevoMeasureLength(filter->GetOutput()), length, 1e-12 * length);
  CHECK_EQUAL(RelevoGetCellPairs(filter->GetOutput()),
    GetCoarsePairs(reference->GetOutput(), refined[0], refined[1]));
  for (int i = 0; i < 2; ++i)
  {
    CHECK_EQUAL(filter->GetOutput(2 + i)->GetNumberOfCells(), scene.Meshes[i]->GetNumberOfCells());
  }

  // Distances are measured to the curved surface. A coarse cell has the smallest distance of its
  // triangles.
  filter->ClassifyOn();
  reference->ClassifyOn();
  RelevoErrors warnings(filter); // holes open a surface, which gives a warning
  filter->Update();
  reference->Update();
  for (int i = 0; i < 2; ++i)
  {
    vtkPolyData* coarse = filter->GetOutput(2 + i);
    vtkPolyData* fine = reference->GetOutput(2 + i);
    std::map<vtkIdType, double> distances;
    for (vtkIdType cell = 0; cell < fine->GetNumberOfCells(); ++cell)
    {
      const double distance = fine->GetCellData()->GetArray("Distance")->GetComponent(cell, 0);
      if (distance >= 0.0)
      {
        const auto place =
          distances.emplace(GetId(refined[i], "vtkOriginalCellIds", cell), distance).first;
        place->second = std::min(place->second, distance);
      }
    }
    CHECK_GREATER(distances.size(), 200);
    for (const auto& [cell, distance] : distances)
    {
      CHECK_NEAR(
        coarse->GetCellData()->GetArray("Distance")->GetComponent(cell, 0), distance, 1e-12);
    }
  }
}

double GetDistance(vtkRefinedCellLocator* locator, const double point[3])
{
  double closest[3];
  vtkIdType cell;
  int part;
  double square;
  locator->FindClosestPoint(point, closest, cell, part, square);
  return std::sqrt(square);
}

void TestTolerance(RelevoCheck& check, int policy)
{
  const Scene scene(6);
  vtkNew<vtkRefinedCellLocator> locators[2];
  vtkNew<vtkMatrix4x4> back;
  vtkMatrix4x4::Invert(scene.Matrix, back);
  auto filter = scene.NewFilter();
  filter->JoinSegmentsOn();
  for (int i = 0; i < 2; ++i)
  {
    locators[i]->SetDataSet(scene.Meshes[i]);
    locators[i]->SetRefinement(scene.Recipes[i]);
  }
  vtkIdType last = 0;
  for (double tolerance : { 0.02, 0.005, 0.00125 })
  {
    for (const auto& recipe : scene.Recipes)
    {
      recipe->SetSegmentPolicy(policy);
    }
    filter->SetTolerance(tolerance);
    filter->Update();
    for (const auto& recipe : scene.Recipes)
    {
      recipe->SetSegmentPolicyToPowersOfTwo(); // the locators need powers of two
    }
    vtkPolyData* curves = filter->GetOutput();
    CHECK_GREATER(curves->GetNumberOfLines(), 0);
    CHECK_EQUAL(curves->GetNumberOfVerts(), 0);
    for (vtkIdType line = 0; line < curves->GetNumberOfLines(); ++line)
    {
      vtkNew<vtkIdList> points;
      curves->GetCellPoints(line, points);
      CHECK_EQUAL(points->GetId(0), points->GetId(points->GetNumberOfIds() - 1));
    }
    double largest = 0.0;
    const vtkIdType step = 1 + curves->GetNumberOfPoints() / 100;
    for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); i += step)
    {
      double x[4] = { 0, 0, 0, 1 };
      curves->GetPoint(i, x);
      largest = std::max(largest, GetDistance(locators[0], x));
      back->MultiplyPoint(x, x);
      largest = std::max(largest, Scale * GetDistance(locators[1], x));
    }
    CHECK_LESS_EQUAL(largest, tolerance);
    CHECK_GREATER(largest, tolerance / 20);

    // Cells stay coarse where nothing intersects. Others get finer with a smaller tolerance.
    vtkPolyData* refined = filter->GetRefinedSurface(0);
    std::map<vtkIdType, int> numbers;
    for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
    {
      ++numbers[GetId(refined, "vtkOriginalCellIds", cell)];
    }
    const auto ones = std::count_if(
      numbers.begin(), numbers.end(), [](const auto& number) { return number.second == 1; });
    CHECK_GREATER(ones, scene.Meshes[0]->GetNumberOfCells() / 2);
    CHECK_GREATER(refined->GetNumberOfCells(), last);
    last = refined->GetNumberOfCells();
  }
}

// Previous queries and metrics of other frames have no effect. Changes take effect.
void TestMotion(RelevoCheck& check)
{
  const Scene scene(5);
  auto filter = scene.NewFilter();
  filter->SetTolerance(0.004);
  filter->Update();
  const int builds = filter->GetNumberOfTreeBuilds();
  filter->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfTreeBuilds(), builds);
  for (double x : { 1.5, -1.4, 0.7 })
  {
    CHECK_CASE(x);
    scene.Matrix->SetElement(0, 3, x);
    filter->Update();
    auto fresh = scene.NewFilter();
    fresh->SetTolerance(0.004);
    fresh->Update();
    for (int port = 0; port < 4; ++port)
    {
      CHECK(RelevoIsSameMesh(filter->GetOutput(port), fresh->GetOutput(port)));
    }
  }
  const double length = RelevoMeasureLength(filter->GetOutput());
  scene.Recipes[1]->GetDisplacement()->SetOffset(0.05);
  filter->Update();
  CHECK_GREATER(std::abs(RelevoMeasureLength(filter->GetOutput()) - length), 0.01);
  filter->SetRefinement(1, nullptr);
  CHECK_EQUAL(filter->GetRefinedSurface(1), nullptr);
  filter->Update();
  filter->SetRefinement(0, nullptr);
  filter->Update();
  vtkNew<vtkSurfaceIntersectionFilter> flat;
  flat->SetInputData(0, scene.Meshes[0]);
  flat->SetInputData(1, scene.Meshes[1]);
  flat->SetMatrix(1, scene.Matrix);
  flat->Update();
  CHECK(RelevoIsSameMesh(filter->GetOutput(), flat->GetOutput()));
}

// With twice the size and twice the tolerance, the number of triangles is the same.
void TestScale(RelevoCheck& check)
{
  const Scene scene(6);
  auto filter = scene.NewFilter();
  filter->SetTolerance(0.004);
  filter->Update();
  const vtkIdType number = filter->GetRefinedSurface(1)->GetNumberOfCells();
  vtkNew<vtkMatrix4x4> twice;
  for (int i = 0; i < 3; ++i)
  {
    twice->SetElement(i, i, 2.0);
  }
  vtkMatrix4x4::Multiply4x4(twice, scene.Matrix, scene.Matrix);
  filter->SetMatrix(0, twice);
  filter->SetTolerance(0.008);
  filter->Update();
  CHECK_EQUAL(filter->GetRefinedSurface(1)->GetNumberOfCells(), number);
  CHECK_GREATER(number, 2 * scene.Meshes[1]->GetNumberOfCells());
}

// A tube thicker than its ring intersects itself, although its coarse mesh does not.
void TestSelf(RelevoCheck& check)
{
  auto mesh = Torus();
  auto recipe = MakeRecipe(2, nullptr, MakeDisplacement(nullptr, 1.0, 0.8));
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(mesh);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), 0);
  filter->SetRefinement(0, recipe);
  filter->Update();
  auto refined = Refine(mesh, recipe);
  vtkNew<vtkSurfaceIntersectionFilter> reference;
  reference->SetInputData(refined);
  reference->Update();
  CHECK_GREATER(filter->GetOutput()->GetNumberOfLines(), 50);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), reference->GetOutput()->GetNumberOfLines());
  CHECK_EQUAL(RelevoGetCellPairs(filter->GetOutput()),
    GetCoarsePairs(reference->GetOutput(), refined, refined));
}

void TestErrors(RelevoCheck& check)
{
  const Scene scene(2);
  auto filter = scene.NewFilter();
  RelevoErrors errors(filter);
  filter->SetRefinement(2, scene.Recipes[0]);
  CHECK(errors.Said("Input"));
  CHECK_EQUAL(filter->GetRefinement(-1), nullptr);
  CHECK(errors.Said("Input"));
  filter->SetTolerance(-0.1);
  CHECK(errors.Said("Tolerance"));
  CHECK_EQUAL(filter->GetTolerance(), 0.0);

  filter->SetTolerance(1e-5);
  filter->Update();
  CHECK(errors.Warned("more than Tolerance"));
  CHECK_GREATER(filter->GetOutput()->GetNumberOfLines(), 0);

  // Without texture coordinates, the heights cannot be sampled.
  RelevoErrors executive(filter->GetExecutive());
  filter->SetInputData(1, RelevoMakeSphere(6, { 1, 0, 0 }, 0.5));
  filter->Update();
  CHECK(errors.Said("Input 1: Cannot refine the input"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(1, vtkNew<vtkPolyData>());
  filter->Update();
  CHECK(errors.Said("Input 1 has no polygons"));

  vtkNew<RelevoHeights> nothing;
  nothing->Fill(4, 4, [](double, double) { return 1.0; });
  nothing->Punch([](int, int) { return true; });
  filter->SetInputData(1, scene.Meshes[1]);
  auto displacement = scene.Recipes[1]->GetDisplacement();
  vtkSmartPointer<vtkHeightField> heights = displacement->GetHeightMap();
  displacement->SetHeightMap(nothing);
  filter->Update();
  CHECK(errors.Said("Input 1 has no refined triangle"));
  displacement->SetHeightMap(heights);
  filter->SetTolerance(0.0);
  filter->Update();
  CHECK_GREATER(filter->GetOutput()->GetNumberOfLines(), 0);
}
}

int TestSurfaceIntersectionRefinement(int, char*[])
{
  RelevoCheck check;
  TestTwin(check, false);
  TestTwin(check, true);
  TestTolerance(check, vtkAdaptiveRefinement::POWERS_OF_TWO);
  TestTolerance(check, vtkAdaptiveRefinement::WHOLE_NUMBERS);
  TestMotion(check);
  TestScale(check);
  TestSelf(check);
  TestErrors(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDisplacement promises: triangles over samples without data are left out, or filled if you
// choose so.
#include "Evaluation/HoleCount.h"
#include "Evaluation/HoleFinder.h"
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <cmath>
#include <random>

using namespace RelevoMeshes;

namespace
{
// Margin, in texels, by which a triangle of texel positions overlaps a sample without data. It is
// negative if the triangle does not.
double getOverlap(const double p[3][2], RelevoHeights* heights)
{
  int n[2];
  heights->GetDimensions(n);
  double overlap = -1e300;
  for (int y = 0; y < n[1]; ++y)
  {
    for (int x = 0; x < n[0]; ++x)
    {
      if (heights->GetValidity()[y * n[0] + x])
      {
        continue;
      }
      // Bilinear interpolation at a vertex uses the samples less than one texel away.
      for (int i = 0; i < 3; ++i)
      {
        const double cx = std::min(std::max(p[i][0], 0.0), n[0] - 1.0);
        const double cy = std::min(std::max(p[i][1], 0.0), n[1] - 1.0);
        overlap = std::max(overlap, std::min(1.0 - std::abs(cx - x), 1.0 - std::abs(cy - y)));
      }
      // A sample is inside if it lies on the same side of all edges.
      double inside[2] = { 1e300, 1e300 };
      for (int i = 0; i < 3; ++i)
      {
        const double* a = p[i];
        const double* b = p[(i + 1) % 3];
        const double dx = b[0] - a[0];
        const double dy = b[1] - a[1];
        const double side = (dx * (y - a[1]) - dy * (x - a[0])) / std::sqrt(dx * dx + dy * dy);
        inside[0] = std::min(inside[0], side);
        inside[1] = std::min(inside[1], -side);
      }
      overlap = std::max(overlap, std::max(inside[0], inside[1]));
    }
  }
  return overlap;
}

void testAgainstSearch(RelevoCheck& check, Mesh mesh, vtkAdaptiveRefinement* recipe,
  RelevoHeights* heights, vtkDisplacement* displacement)
{
  int n[2];
  heights->GetDimensions(n);
  displacement->SetNoDataPolicyToFill();
  Mesh full = Refine(mesh, recipe);
  displacement->SetNoDataPolicyToHole();
  Mesh holed = Refine(mesh, recipe);
  int left = 0;
  int kept = 0;
  int uncertain = 0;
  vtkNew<vtkIdList> ids;
  auto getPositions = [&](vtkPolyData* refined, vtkIdType cell, double p[3][2])
  {
    refined->GetCellPoints(cell, ids);
    for (int i = 0; i < 3; ++i)
    {
      double uv[2];
      refined->GetPointData()->GetTCoords()->GetTuple(ids->GetId(i), uv);
      for (int c = 0; c < 2; ++c)
      {
        p[i][c] = std::min(std::max(uv[c], 0.0), 1.0) * n[c] - 0.5;
      }
    }
  };
  constexpr double margin = 1e-4;
  double p[3][2];
  for (vtkIdType cell = 0; cell < full->GetNumberOfCells(); ++cell)
  {
    getPositions(full, cell, p);
    const double overlap = getOverlap(p, heights);
    (std::abs(overlap) < margin ? uncertain : overlap > 0.0 ? left : kept) += 1;
  }
  CHECK_GREATER(left, 0);
  CHECK_GREATER(kept, 0);
  CHECK_GREATER_EQUAL(holed->GetNumberOfCells(), kept);
  CHECK_LESS_EQUAL(holed->GetNumberOfCells(), kept + uncertain);
  for (vtkIdType cell = 0; cell < holed->GetNumberOfCells(); ++cell)
  {
    getPositions(holed, cell, p);
    CHECK_LESS(getOverlap(p, heights), margin);
  }
  // Every point of the output is used, and its data are kept.
  std::vector<bool> used(static_cast<size_t>(holed->GetNumberOfPoints()), false);
  for (vtkIdType cell = 0; cell < holed->GetNumberOfCells(); ++cell)
  {
    holed->GetCellPoints(cell, ids);
    for (int i = 0; i < 3; ++i)
    {
      used[ids->GetId(i)] = true;
    }
  }
  CHECK_EQUAL(std::find(used.begin(), used.end(), false), used.end());
  CHECK_EQUAL(holed->GetCellData()->GetArray("vtkOriginalCellIds")->GetNumberOfTuples(),
    holed->GetNumberOfCells());
  for (vtkIdType i = 0; i < holed->GetNumberOfPoints(); ++i)
  {
    CHECK_NEAR(holed->GetPointData()->GetArray("x")->GetTuple1(i), holed->GetPoint(i)[0], 1e-6);
  }
  // The mapper uses the same count of triangles as the filter.
  relevo::RefinementMesh refinementMesh;
  CHECK(refinementMesh.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
  relevo::EdgeTags tags;
  std::string error;
  CHECK(tags.Compute(recipe, mesh, refinementMesh, {}, error));
  relevo::PatternSelection selection;
  selection.Select(
    refinementMesh, tags, *relevo::GetPatternFamily(recipe, mesh), recipe->GetMaximumLevel());
  CHECK_EQUAL(
    relevo::CountHoles(refinementMesh, selection, relevo::GetHoles(recipe->GetDisplacement())),
    full->GetNumberOfCells() - holed->GetNumberOfCells());
}

void addX(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> x;
  x->SetName("x");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[0]));
  }
  mesh->GetPointData()->AddArray(x);
}

// A height field and a recipe that displaces by it.
struct Scene
{
  Scene()
  {
    this->Displacement->SetHeightMap(this->Heights);
    this->Displacement->SetScale(0.1);
    this->Recipe->SetDisplacement(this->Displacement);
  }

  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkAdaptiveRefinement> Recipe;
};

// Displaces along the normal at level 4.
struct SquareScene : Scene
{
  SquareScene()
  {
    this->Heights->FillRandom(16, 16, 5);
    this->Recipe->SetMaximumLevel(4);
    this->Displacement->SetDirectionToNormal();
  }
};

// Texture coordinates are skewed so that no sample lies on an edge.
Mesh makeSkewedPlane()
{
  Mesh plane = Plane(3, 3);
  addX(plane);
  vtkDataArray* uvs = plane->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < uvs->GetNumberOfTuples(); ++i)
  {
    double uv[2];
    uvs->GetTuple(i, uv);
    uvs->SetTuple2(i, 0.02 + 0.9 * uv[0] + 0.07 * uv[1], 0.97 * uv[1] - 0.03 * uv[0] + 0.03);
  }
  return plane;
}

Mesh makeChartedSphere()
{
  Mesh sphere = Sphere(8, 6);
  AddTextureCoordinates(sphere,
    [](const double* p) {
      return std::array<double, 2>{ { p[0] + 0.5, p[1] + 0.5 } };
    });
  AddTags(sphere, 4, 4);
  return sphere;
}

// Random holes inside, at the border and in corners, for triangles larger and smaller than texels.
void testRandomHoles(RelevoCheck& check)
{
  Scene scene;
  CHECK_EQUAL(scene.Displacement->GetNoDataPolicy(), vtkDisplacement::HOLE);
  scene.Displacement->SetDirection(0.0, 0.0, 1.0);
  const int sizes[][2] = { { 37, 29 }, { 7, 5 }, { 101, 3 } };
  for (const auto& size : sizes)
  {
    for (int level : { 1, 3, 4 })
    {
      if (size[0] * level >= 100)
      {
        continue;
      }
      for (unsigned int seed = 0; seed < 4; ++seed)
      {
        scene.Heights->FillRandom(size[0], size[1], seed);
        std::mt19937 random(seed);
        const int holeX = static_cast<int>(random() % size[0]);
        const int holeY = static_cast<int>(random() % size[1]);
        scene.Heights->Punch([&](int x, int y)
          { return (x == holeX && y == holeY) || (seed == 3 && x == 0 && y == 0); });
        scene.Recipe->SetMaximumLevel(level);
        Mesh plane = makeSkewedPlane();
        scene.Displacement->SetNoDataPolicyToHole();
        Mesh holed = Refine(plane, scene.Recipe);
        if (holed->GetNumberOfCells() == 18 << 2 * level || holed->GetNumberOfCells() == 0)
        {
          continue; // the hole lies outside the texture coordinates or covers all of them
        }
        testAgainstSearch(check, plane, scene.Recipe, scene.Heights, scene.Displacement);
      }
    }
  }
}

// With Fill every triangle stays and the surface is closed. With holes the remaining triangles meet
// exactly: no edge is used three times, or twice in the same direction.
void testClosed(RelevoCheck& check)
{
  SquareScene scene;
  Mesh sphere = makeChartedSphere();
  scene.Heights->Punch([](int x, int y) { return x > 5 && x < 9 && y > 5 && y < 9; });
  scene.Displacement->SetNoDataPolicyToFill();
  CHECK(!scene.Displacement->HasHoles());
  CHECK(RelevoWatertight::FindError(sphere, Refine(sphere, scene.Recipe), 4).empty());
  scene.Displacement->SetNoDataPolicyToHole();
  CHECK(scene.Displacement->HasHoles());
  Mesh holed = Refine(sphere, scene.Recipe);
  RelevoWatertight::EdgeUses edges;
  const auto welded = RelevoWatertight::Weld(holed->GetPoints(), false);
  for (const auto& triangle : RelevoWatertight::GetTriangles(holed, welded))
  {
    for (int i = 0; i < 3; ++i)
    {
      RelevoWatertight::Use(edges, welded[triangle[i]], welded[triangle[(i + 1) % 3]]);
    }
  }
  for (const auto& edge : edges)
  {
    CHECK_LESS_EQUAL(edge.second.first, 1);
    CHECK_LESS_EQUAL(edge.second.second, 1);
  }
}

// Without data, only vertices and lines remain.
void testNoData(RelevoCheck& check)
{
  SquareScene scene;
  scene.Heights->Punch([](int, int) { return true; });
  Mesh sphere = makeChartedSphere();
  CHECK_EQUAL(Refine(sphere, scene.Recipe)->GetNumberOfCells(), 0);
  CHECK_EQUAL(Refine(sphere, scene.Recipe)->GetNumberOfPoints(), 0);
  Mesh mixed = Mixed();
  AddTextureCoordinates(mixed,
    [](const double* p) {
      return std::array<double, 2>{ { p[0] / 6.0, p[1] / 4.0 } };
    });
  Mesh rest = Refine(mixed, scene.Recipe);
  CHECK_EQUAL(rest->GetNumberOfCells(), 3);
  CHECK_EQUAL(rest->GetNumberOfVerts(), 2);
  CHECK_EQUAL(rest->GetNumberOfPoints(), 5); // points 0, 1, 2, 22 and 23
}

// If all texture coordinates are equal, one sample decides for the whole mesh.
void testOneSample(RelevoCheck& check)
{
  SquareScene scene;
  Mesh point = Plane(1, 1);
  AddTextureCoordinates(point,
    [](const double*) {
      return std::array<double, 2>{ { 0.53, 0.53 } };
    });
  scene.Heights->Punch([](int x, int y) { return x == 0 && y == 0; });
  CHECK_EQUAL(Refine(point, scene.Recipe)->GetNumberOfCells(), 2 * 256);
  scene.Heights->Punch([](int x, int y) { return x == 8 && y == 8; });
  CHECK_EQUAL(Refine(point, scene.Recipe)->GetNumberOfCells(), 0);
}
}

int TestDisplacementHoles(int, char*[])
{
  RelevoCheck check;
  testRandomHoles(check);
  testClosed(check);
  testNoData(check);
  testOneSample(check);
  return check.GetResult();
}

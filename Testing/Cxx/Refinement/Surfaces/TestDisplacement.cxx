// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDisplacement promises: the displaced point is point + (Offset + Scale * height) * direction.
// At seams and split normals, both sides move together.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkDisplacement.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>
#include <iostream>
#include <random>

using namespace RelevoMeshes;

namespace
{
// Bilinear interpolation between texel centres at (i + 0.5) / n, clamped outside. Row 0 is at v =
// 0.
double getHeight(vtkHeightField* heights, double u, double v)
{
  int n[2];
  heights->GetDimensions(n);
  auto sample = [&](int x, int y)
  {
    x = std::min(std::max(x, 0), n[0] - 1);
    y = std::min(std::max(y, 0), n[1] - 1);
    return static_cast<double>(heights->GetSamples()[y * n[0] + x]);
  };
  const double x = std::min(std::max(u, 0.0), 1.0) * n[0] - 0.5;
  const double y = std::min(std::max(v, 0.0), 1.0) * n[1] - 0.5;
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const double s = x - i;
  const double t = y - j;
  return (1 - t) * ((1 - s) * sample(i, j) + s * sample(i + 1, j)) +
    t * ((1 - s) * sample(i, j + 1) + s * sample(i + 1, j + 1));
}

void testHeights(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(4, 2, [](double u, double v) { return 100.0 * u + 10.0 * v; });
  CHECK_NEAR(heights->GetHeight(0.125, 0.25), 12.5 + 2.5, 1e-5);
  CHECK_NEAR(heights->GetHeight(0.0, 0.0), 12.5 + 2.5, 1e-5);
  CHECK_NEAR(heights->GetHeight(1.0, 1.0), 87.5 + 7.5, 1e-5);
  CHECK_NEAR(heights->GetHeight(-3.0, 7.0), 12.5 + 7.5, 1e-5);
  CHECK_NEAR(heights->GetHeight(0.4, 0.5), 45.0, 1e-5);
  heights->FillRandom(7, 5, 4);
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i)
  {
    const double u = 1.2 * (random() / 4294967296.0) - 0.1;
    const double v = 1.2 * (random() / 4294967296.0) - 0.1;
    CHECK_NEAR(heights->GetHeight(u, v), getHeight(heights, u, v), 2e-6);
  }
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  displacement->SetScale(-2.0);
  displacement->SetOffset(1.0);
  double range[2];
  double reach[2];
  heights->GetRange(range);
  displacement->GetReach(reach);
  CHECK_NEAR(reach[0], 1.0 - 2.0 * range[1], 1e-12);
  CHECK_NEAR(reach[1], 1.0 - 2.0 * range[0], 1e-12);
}

// The reference is the same recipe without displacement: its points and unit normals.
void testFormula(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(9, 6, 6);
  vtkNew<vtkPNTriangleSurface> quadratic;
  vtkNew<vtkPNTriangleSurface> linearNormals;
  linearNormals->QuadraticNormalsOff();
  const double utm[3] = { 412345.678, 5654321.987, 312.5 };
  Mesh smooth = Sphere(10, 8);
  AddTextureCoordinates(smooth,
    [](const double* p) {
      return std::array<double, 2>{ { 0.5 + p[0], 0.7 + 1.2 * p[1] } };
    });
  const std::pair<const char*, Mesh> meshes[] = { { "plane", Plane(4, 3) }, { "sphere", smooth },
    { "projected metres", Moved(smooth, 10.0, utm, VTK_DOUBLE) } };
  const double direction[3] = { 1.0, -2.0, 2.0 };
  for (const auto& mesh : meshes)
  {
    AddTags(mesh.second, 6, 5);
    for (vtkRefinementSurface* surface :
      std::initializer_list<vtkRefinementSurface*>{ nullptr, quadratic, linearNormals })
    {
      for (int kind = 0; kind < 4; ++kind)
      {
        vtkNew<vtkAdaptiveRefinement> recipe;
        recipe->SetMaximumLevel(4);
        recipe->SetSurface(surface);
        Mesh plain = Refine(mesh.second, recipe);
        vtkNew<vtkDisplacement> displacement;
        displacement->SetHeightMap(kind == 3 ? nullptr : heights.Get());
        displacement->SetScale(kind == 1 ? -0.7 : 0.3);
        displacement->SetOffset(0.25 * kind);
        if (kind == 2)
        {
          displacement->SetDirection(direction);
        }
        recipe->SetDisplacement(displacement);
        Mesh displaced = Refine(mesh.second, recipe);
        if (!CHECK_EQUAL(displaced->GetNumberOfPoints(), plain->GetNumberOfPoints()))
        {
          continue;
        }
        const double size = mesh.second->GetLength();
        for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
        {
          double uv[2];
          plain->GetPointData()->GetTCoords()->GetTuple(i, uv);
          const double height = displacement->GetOffset() +
            (kind == 3 ? 0.0 : displacement->GetScale() * getHeight(heights, uv[0], uv[1]));
          double p[3];
          double q[3];
          double n[3];
          plain->GetPoint(i, p);
          displaced->GetPoint(i, q);
          plain->GetPointData()->GetNormals()->GetTuple(i, n);
          for (int c = 0; c < 3; ++c)
          {
            const double along = kind == 2 ? direction[c] / 3.0 : n[c];
            CHECK_NEAR(q[c], p[c] + height * along, 2e-6 * size);
          }
        }
      }
    }
  }
}

// At a texture seam, points 0 to 3 see the left half of the map and points 4 to 7 the right half.
void testSeam(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(32, 32, 8);
  for (bool swapped : { false, true })
  {
    // Two adjacent squares. The seam is at x = 1, with points 1, 2, 4 and 7 on it.
    std::vector<std::array<double, 3>> points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
      { { 0, 1, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 2, 1, 0 } }, { { 1, 1, 0 } } };
    std::vector<Triangle> triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } }, { { 4, 5, 6 } },
      { { 4, 6, 7 } } };
    if (swapped)
    {
      std::rotate(points.begin(), points.begin() + 4, points.end());
    }
    Mesh mesh = FromTriangles(points, triangles);
    vtkNew<vtkFloatArray> uvs;
    uvs->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      const double* p = mesh->GetPoint(i);
      uvs->InsertNextTuple2(i < 4 ? 0.2 * p[0] : 1.0 - 0.3 * p[0], 0.1 + 0.8 * p[1]);
    }
    mesh->GetPointData()->SetTCoords(uvs);
    vtkNew<vtkDisplacement> displacement;
    displacement->SetHeightMap(heights);
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetMaximumLevel(3);
    recipe->SetDisplacement(displacement);
    Mesh refined = Refine(mesh, recipe);
    int onSeam = 0;
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      const double* p = refined->GetPoint(i);
      if (p[0] == 1.0)
      {
        // The point with the lower id provides the texture coordinates.
        CHECK_NEAR(p[2], getHeight(heights, 0.2, 0.1 + 0.8 * p[1]), 2e-6);
        ++onSeam;
      }
      else
      {
        double uv[2];
        refined->GetPointData()->GetTCoords()->GetTuple(i, uv);
        CHECK_NEAR(p[2], getHeight(heights, uv[0], uv[1]), 2e-6);
      }
    }
    CHECK_EQUAL(onSeam, 2 * 9);
  }
}

// Normals on the two sides of a texture seam often differ only by rounding. Such an edge is not a
// crease.
void testRoundedNormals(RelevoCheck& check)
{
  Mesh sphere = TexturedSphere(16, 12);
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(3);
  recipe->SetSurface(surface);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  RelevoErrors errors(filter); // the triangles at the poles are degenerate
  filter->SetInputData(sphere);
  filter->SetRefinement(recipe);
  filter->Update();
  Mesh plain = Make();
  plain->ShallowCopy(filter->GetOutput());
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.25);
  recipe->SetDisplacement(displacement);
  filter->Update();
  for (vtkIdType i = sphere->GetNumberOfPoints(); i < plain->GetNumberOfPoints(); ++i)
  {
    double expected[3];
    const double* n = plain->GetPointData()->GetNormals()->GetTuple(i);
    for (int c = 0; c < 3; ++c)
    {
      expected[c] = plain->GetPoint(i)[c] + 0.25 * n[c];
    }
    CHECK_LESS(
      std::sqrt(vtkMath::Distance2BetweenPoints(expected, filter->GetOutput()->GetPoint(i))), 1e-5);
  }
}

// Where normals are split, both sides move along their mean.
void testSplitNormals(RelevoCheck& check)
{
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.1);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(0);
  recipe->SetDisplacement(displacement);
  Mesh cube = Cube();
  Mesh refined = Refine(cube, recipe);
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    const double grown = 1.0 + 0.1 / std::sqrt(0.75);
    for (int c = 0; c < 3; ++c)
    {
      CHECK_NEAR(refined->GetPoint(i)[c], grown * cube->GetPoint(i)[c], 1e-6);
    }
  }
  // A vertex cell at a corner has no influence.
  Mesh withVertex = Make();
  withVertex->DeepCopy(cube);
  const vtkIdType vertex = withVertex->GetPoints()->InsertNextPoint(cube->GetPoint(0));
  withVertex->GetPointData()->GetNormals()->InsertNextTuple3(0.0, 1.0, 0.0);
  withVertex->GetPointData()->GetTCoords()->InsertNextTuple2(0.0, 0.0);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell(1, &vertex);
  withVertex->SetVerts(verts);
  Mesh other = Refine(withVertex, recipe);
  CHECK_LESS(vtkMath::Distance2BetweenPoints(other->GetPoint(0), refined->GetPoint(0)), 1e-12);
}

// Vertices and lines stay in place, even if they share points with faces that move.
void testOtherCells(RelevoCheck& check)
{
  Mesh mesh = Mixed();
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.25);
  recipe->SetDisplacement(displacement);
  Mesh refined = Refine(mesh, recipe);
  const vtkIdType numberOfOthers = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  CHECK_GREATER(numberOfOthers, 0);
  CHECK_GREATER(refined->GetNumberOfCells(), numberOfOthers);
  int sharedPoints = 0;
  for (vtkIdType cell = 0; cell < numberOfOthers; ++cell)
  {
    vtkNew<vtkIdList> before;
    vtkNew<vtkIdList> after;
    mesh->GetCellPoints(cell, before);
    refined->GetCellPoints(cell, after);
    CHECK_EQUAL(before->GetNumberOfIds(), after->GetNumberOfIds());
    for (vtkIdType i = 0; i < before->GetNumberOfIds(); ++i)
    {
      double expected[3];
      double found[3];
      mesh->GetPoint(before->GetId(i), expected);
      refined->GetPoint(after->GetId(i), found);
      CHECK(std::equal(expected, expected + 3, found));
      sharedPoints += before->GetId(i) != after->GetId(i);
    }
  }
  CHECK_GREATER(sharedPoints, 0);
  double bounds[6];
  mesh->GetBounds(bounds);
  double moved[6];
  refined->GetBounds(moved);
  CHECK(!std::equal(bounds, bounds + 6, moved));
}
}

int TestDisplacement(int, char*[])
{
  RelevoCheck check;
  testHeights(check);
  testFormula(check);
  testSeam(check);
  testRoundedNormals(check);
  testSplitNormals(check);
  testOtherCells(check);
  vtkNew<vtkDisplacement> displacement;
  displacement->Print(std::cout);
  return check.GetResult();
}

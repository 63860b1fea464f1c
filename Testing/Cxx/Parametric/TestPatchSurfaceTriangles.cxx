// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurfaceFilter promises coarse triangles that cover each patch: for closed borders, for
// borders and diagonals with the same ends, and for borders that collapse to a point.
#include "RelevoCheck.h"
#include "RelevoCurves.h"
#include "RelevoPatches.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkBezierPatchReader.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPatchSurface.h"
#include "vtkPointData.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <set>

namespace
{
RelevoPosition GetPosition(vtkPolyData* mesh, vtkIdType point)
{
  RelevoPosition x;
  mesh->GetPoint(point, x.data());
  return { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 };
}

// Corners of a triangle as points and as parameters of its patch.
struct Triangle
{
  Triangle(vtkPolyData* mesh, vtkIdType cell)
    : Patch(static_cast<int>(mesh->GetCellData()->GetArray("PatchIds")->GetTuple1(cell)))
  {
    vtkNew<vtkIdList> points;
    mesh->GetCellPoints(cell, points);
    for (int k = 0; k < 3; ++k)
    {
      vtkDataArray* coordinates = mesh->GetCellData()->GetArray("PatchCoordinates");
      this->Points[k] = points->GetId(k);
      this->U[k] = coordinates->GetComponent(cell, 2 * k);
      this->V[k] = coordinates->GetComponent(cell, 2 * k + 1);
    }
  }

  double GetArea() const
  {
    return 0.5 *
      ((this->U[1] - this->U[0]) * (this->V[2] - this->V[0]) -
        (this->U[2] - this->U[0]) * (this->V[1] - this->V[0]));
  }

  int Patch;
  std::array<vtkIdType, 3> Points;
  std::array<double, 3> U;
  std::array<double, 3> V;
};

// Triangles cover their patches and agree with them at the corners. No two curves connect the same
// merged points, except at a collapsed border.
void CheckTriangles(RelevoCheck& check, vtkPolyData* mesh)
{
  std::vector<double> areas(RelevoGetNumberOfPatches(mesh), 0.0);
  std::map<std::set<RelevoPosition>, std::vector<double>> curves;
  std::set<RelevoPosition> poles;
  for (int pass = 0; pass < 2; ++pass)
  {
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      const Triangle triangle(mesh, cell);
      for (int k = 0; k < 3; ++k)
      {
        const int next = (k + 1) % 3;
        const RelevoPosition start = GetPosition(mesh, triangle.Points[k]);
        const RelevoPosition end = GetPosition(mesh, triangle.Points[next]);
        CHECK_NOT_EQUAL(triangle.Points[k], triangle.Points[next]);
        if (pass == 0)
        {
          const auto x = RelevoEvaluatePatch(mesh, triangle.Patch, triangle.U[k], triangle.V[k]);
          CHECK_NEAR(RelevoGetDistance({ x[0], x[1], x[2] }, start), 0.0, 1e-13);
          CHECK_EQUAL(triangle.U[k] * 32768.0, std::floor(triangle.U[k] * 32768.0));
          if (start == end)
          {
            poles.insert(start);
          }
          continue;
        }
        if (poles.count(start) || poles.count(end))
        {
          continue;
        }
        const auto middle = RelevoEvaluatePatch(mesh, triangle.Patch,
          0.5 * (triangle.U[k] + triangle.U[next]), 0.5 * (triangle.V[k] + triangle.V[next]));
        const auto [curve, isNew] = curves.insert({ { start, end }, middle });
        CHECK_NEAR(RelevoGetDistance({ middle[0], middle[1], middle[2] },
                     { curve->second[0], curve->second[1], curve->second[2] }),
          0.0, 1e-13);
      }
      areas[triangle.Patch] += pass == 0 ? triangle.GetArea() : 0.0;
      CHECK_GREATER(triangle.GetArea(), 0.0);
    }
  }
  for (int patch = 0; patch < RelevoGetNumberOfPatches(mesh); ++patch)
  {
    CHECK_NEAR(areas[patch], RelevoIsTriangle(mesh, patch) ? 0.5 : 1.0, 1e-12);
  }
}

using Shape = std::function<RelevoPosition(double, double)>;

// A Bézier quadrilateral whose control points are given by a function of u and v.
void AddPatch(vtkUnstructuredGrid* grid, int p, int q, const Shape& shape)
{
  const std::array<int, 2> order{ p, q };
  std::vector<vtkIdType> ids((p + 1) * (q + 1));
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const RelevoPosition x = shape(i / static_cast<double>(p), j / static_cast<double>(q));
      ids[vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, order.data())] =
        grid->GetPoints()->InsertNextPoint(x.data());
    }
  }
  grid->InsertNextCell(VTK_BEZIER_QUADRILATERAL, static_cast<vtkIdType>(ids.size()), ids.data());
  grid->GetCellData()->GetHigherOrderDegrees()->InsertNextTuple3(p, q, 0);
}

vtkSmartPointer<vtkUnstructuredGrid> NewGrid()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  grid->Allocate(1);
  vtkNew<vtkIntArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  return grid;
}

// The loop closes exactly.
RelevoPosition GetLoop(double u)
{
  const double angle = 2.0 * vtkMath::Pi() * (u == 1.0 ? 0.0 : u);
  return { std::cos(angle), std::sin(angle), 0.0 };
}

void TestClosed(RelevoCheck& check)
{
  auto cylinder = NewGrid();
  AddPatch(cylinder, 4, 1,
    [](double u, double v) {
      return RelevoPosition{ GetLoop(u)[0], GetLoop(u)[1], v };
    });
  auto mesh = RelevoMakePatches(cylinder);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 16);
  CheckTriangles(check, mesh);

  auto torus = NewGrid();
  AddPatch(torus, 5, 4,
    [](double u, double v)
    {
      const double radius = 3.0 + GetLoop(v)[0];
      return RelevoPosition{ radius * GetLoop(u)[0], radius * GetLoop(u)[1], GetLoop(v)[1] };
    });
  mesh = RelevoMakePatches(torus);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 22);
  CheckTriangles(check, mesh);

  for (const RelevoSpline& spline : { RelevoMakeTorus(3.0, 1.0) })
  {
    auto source = spline.NewSource();
    source->Update();
    mesh = RelevoMakePatches(source->GetOutput());
    CHECK_EQUAL(mesh->GetNumberOfCells(), 2 * source->GetOutput()->GetNumberOfCells());
    CheckTriangles(check, mesh);
    auto split = RelevoMakePatches(source->GetOutput(), true);
    CHECK_EQUAL(split->GetNumberOfCells(), 8 * source->GetOutput()->GetNumberOfCells());
    CheckTriangles(check, split);
    // Normals are those of the torus.
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const RelevoPosition x = GetPosition(mesh, i);
      const double radius = std::hypot(x[0], x[1]);
      RelevoPosition normal;
      mesh->GetPointData()->GetNormals()->GetTuple(i, normal.data());
      const RelevoPosition expected{ x[0] - 3.0 * x[0] / radius, x[1] - 3.0 * x[1] / radius, x[2] };
      CHECK_NEAR(std::abs(vtkMath::Dot(normal.data(), expected.data())), 1.0, 1e-6);
    }
  }
}

// Two sheets that share all four borders and are arched by their inner control points.
void TestPillow(RelevoCheck& check)
{
  auto grid = NewGrid();
  for (double height : { 1.0, -1.0, 2.0 })
  {
    CHECK_CASE(height);
    AddPatch(grid, 3, 3,
      [=](double u, double v) {
        return RelevoPosition{ u, v, u * (1.0 - u) * v * (1.0 - v) * height };
      });
    auto mesh = RelevoMakePatches(grid);
    CheckTriangles(check, mesh);
    const vtkIdType patches = grid->GetNumberOfCells();
    CHECK_EQUAL(mesh->GetNumberOfCells(), (patches == 3 ? 8 : 2 * patches));
    CHECK_EQUAL(mesh->GetNumberOfPoints(), 4 * patches + (patches == 3 ? 1 : 0));
  }
}

// Two quadratic triangles whose edges connect the same corners along different arcs.
void TestLens(RelevoCheck& check)
{
  auto grid = NewGrid();
  for (double side : { 1.0, -1.0 })
  {
    const RelevoPosition places[6] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, side, 0 },
      { 0.5, 0.2 * side, 0 }, { 0.75, 0.6 * side, 0.1 }, { 0.25, 0.5 * side, 0.1 } };
    std::array<vtkIdType, 6> ids;
    for (int i = 0; i < 6; ++i)
    {
      ids[i] = grid->GetPoints()->InsertNextPoint(places[i].data());
    }
    grid->InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, ids.data());
    grid->GetCellData()->GetHigherOrderDegrees()->InsertNextTuple3(2, 2, 2);
  }
  vtkNew<vtkDoubleArray> values; // a coordinate, which shows the values at split points
  values->SetName("X");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(grid->GetPoint(i)[0]);
  }
  grid->GetPointData()->AddArray(values);
  auto mesh = RelevoMakePatches(grid);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 8);
  CheckTriangles(check, mesh);
  CHECK_EQUAL(RelevoMakePatches(grid, true)->GetNumberOfCells(), 12);
  CheckTriangles(check, RelevoMakePatches(grid, true));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    CHECK_NEAR(mesh->GetPointData()->GetArray("X")->GetTuple1(i), GetPosition(mesh, i)[0], 1e-14);
  }
}

// A cap of four patches around a pole, which are neighbours by point ids, and a cone of one patch.
void TestPoles(RelevoCheck& check)
{
  auto grid = NewGrid();
  for (int k = 0; k < 4; ++k)
  {
    AddPatch(grid, 3, 2,
      [=](double u, double v)
      {
        const RelevoPosition x = GetLoop(0.25 * (k + u));
        return RelevoPosition{ v * x[0], v * x[1], 1.0 };
      });
  }
  auto mesh = RelevoMakePatches(grid);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 8);
  CheckTriangles(check, mesh);
  std::map<vtkIdType, std::set<int>> patches; // by point at the pole
  for (vtkIdType cell = 0; cell < 8; ++cell)
  {
    const Triangle triangle(mesh, cell);
    for (vtkIdType point : triangle.Points)
    {
      if (GetPosition(mesh, point) == RelevoPosition{ 0.0, 0.0, 1.0 })
      {
        patches[point].insert(triangle.Patch);
        CHECK_NEAR(mesh->GetPointData()->GetNormals()->GetComponent(point, 2), -1.0, 1e-5);
      }
    }
  }
  CHECK_EQUAL(patches.size(), 4);
  for (const auto& point : patches)
  {
    CHECK_EQUAL(point.second.size(), 2);
  }

  auto cone = NewGrid();
  AddPatch(cone, 4, 1,
    [](double u, double v) {
      return RelevoPosition{ v * GetLoop(u)[0], v * GetLoop(u)[1], v };
    });
  mesh = RelevoMakePatches(cone);
  CheckTriangles(check, mesh);
}

// Patches that meet themselves along a seam from pole to pole: a ball of one quadrilateral, and a
// leaf of one triangle. Both are closed surfaces at every level.
void TestSeams(RelevoCheck& check)
{
  auto ball = NewGrid();
  AddPatch(ball, 5, 3,
    [](double u, double v)
    {
      const double radius = v == 0.0 || v == 1.0 ? 0.0 : 1.0;
      return RelevoPosition{ radius * GetLoop(u)[0], radius * GetLoop(u)[1], v < 0.5 ? 1.0 : -1.0 };
    });
  auto leaf = NewGrid();
  std::array<vtkIdType, 15> ids;
  for (int j = 0; j <= 4; ++j)
  {
    for (int i = 0; i + j <= 4; ++i)
    {
      const bool isBorder = i == 0 || j == 0 || i + j == 4;
      const double side = i < j ? 4.0 : (i > j ? -4.0 : 0.0);
      const std::array<vtkIdType, 3> index{ i, j, 4 - i - j };
      ids[vtkHigherOrderTriangle::Index(index.data(), 4)] = leaf->GetPoints()->InsertNextPoint(
        i + j, isBorder ? 0.0 : side, isBorder || side != 0.0 ? 0.0 : 8.0);
    }
  }
  leaf->InsertNextCell(VTK_BEZIER_TRIANGLE, 15, ids.data());
  leaf->GetCellData()->GetHigherOrderDegrees()->InsertNextTuple3(4, 4, 4);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  recipe->SetMaximumLevel(5);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(recipe);
  for (vtkUnstructuredGrid* grid : { ball.Get(), leaf.Get() })
  {
    std::array<double, 2> volumes;
    for (bool split : { false, true })
    {
      CHECK_CASE(split);
      auto mesh = RelevoMakePatches(grid, split);
      CheckTriangles(check, mesh);
      filter->SetInputData(mesh);
      filter->Update();
      CHECK_EQUAL(RelevoCountOpenEdges(filter->GetOutput()), 0);
      volumes[split] = std::abs(RelevoGetVolume(filter->GetOutput()));
    }
    CHECK_GREATER(volumes[0], 0.1);
    CHECK_NEAR(volumes[0] / volumes[1], 1.0, 0.005);
  }
}

void TestTeapot(RelevoCheck& check)
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string name = std::string(data ? data : "") + "/mesh/teapot.bpt";
  if (!std::ifstream(name))
  {
    std::cerr << "RELEVO_TEST_DATA has no mesh/teapot.bpt\n";
    return;
  }
  vtkNew<vtkBezierPatchReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  auto mesh = RelevoMakePatches(reader->GetOutput());
  // Handle and spout are rings of two patches each, so six merged points along them are connected
  // by two edges.
  CHECK_EQUAL(mesh->GetNumberOfCells(), 24 * 2 + 8 * 6);
  CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), 32);
  CheckTriangles(check, mesh);
  int atPoles = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const Triangle triangle(mesh, cell);
    std::set<RelevoPosition> places;
    for (vtkIdType point : triangle.Points)
    {
      places.insert(GetPosition(mesh, point));
    }
    atPoles += places.size() == 2 ? 1 : 0;
  }
  CHECK_EQUAL(atPoles, 8);

  // At the poles three borders are split, elsewhere four.
  mesh = RelevoMakePatches(reader->GetOutput(), true);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 24 * 8 + 8 * 7);
  CheckTriangles(check, mesh);
}
}

int TestPatchSurfaceTriangles(int, char*[])
{
  RelevoCheck check;
  TestClosed(check);
  TestPillow(check);
  TestLens(check);
  TestPoles(check);
  TestSeams(check);
  TestTeapot(check);
  return check.GetResult();
}

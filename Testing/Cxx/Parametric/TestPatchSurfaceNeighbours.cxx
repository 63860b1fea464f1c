// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurfaceFilter promises that inner faces of adjacent cells are removed and that common
// edges are equal, bit for bit.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace
{
using Curve = std::vector<std::array<double, 4>>;

std::vector<Curve> GetBorders(vtkPolyData* mesh, int patch)
{
  vtkDataArray* table = mesh->GetFieldData()->GetArray("Patches");
  vtkDataArray* points = mesh->GetFieldData()->GetArray("PatchPoints");
  const bool isTriangle = RelevoIsTriangle(mesh, patch);
  const int p = static_cast<int>(table->GetComponent(patch, 1));
  const int q = static_cast<int>(table->GetComponent(patch, 2));
  std::map<std::array<int, 2>, std::array<double, 4>> net;
  auto point = static_cast<vtkIdType>(table->GetComponent(patch, 3));
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= (isTriangle ? p - j : p); ++i)
    {
      points->GetTuple(point++, net[{ i, j }].data());
    }
  }
  std::vector<Curve> borders(isTriangle ? 3 : 4);
  for (int k = 0; k <= p; ++k)
  {
    borders[0].push_back(net[{ k, 0 }]);
    isTriangle ? borders[1].push_back(net[{ p - k, k }]) : borders[2].push_back(net[{ k, q }]);
  }
  for (int k = 0; k <= q; ++k)
  {
    borders[isTriangle ? 2 : 1].push_back(net[{ isTriangle ? 0 : p, k }]);
    if (!isTriangle)
    {
      borders[3].push_back(net[{ 0, k }]);
    }
  }
  for (Curve& border : borders)
  {
    const Curve reversed(border.rbegin(), border.rend());
    border = std::min(border, reversed);
  }
  return borders;
}

// Number of patches at each border.
std::map<Curve, int> CountBorders(vtkPolyData* mesh)
{
  std::map<Curve, int> counts;
  for (int patch = 0; patch < RelevoGetNumberOfPatches(mesh); ++patch)
  {
    for (const Curve& border : GetBorders(mesh, patch))
    {
      ++counts[border];
    }
  }
  return counts;
}

RelevoPosition Bend(const RelevoPosition& x)
{
  return { x[0] + 0.07 * std::sin(x[1] + 2.0 * x[2]), x[1] + 0.06 * std::sin(1.3 * x[2] - x[0]),
    x[2] + 0.05 * std::cos(x[0] + x[1]) };
}

// Cells of one kind in a unit cube, each by its corners.
using Corners = std::vector<RelevoPosition>;

std::vector<Corners> SplitCube(int shape)
{
  const Corners c{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.5, 0.5 } };
  const std::map<int, std::vector<std::vector<int>>> cells{ { 4,
                                                              { { 0, 1, 2, 6 }, { 0, 2, 3, 6 },
                                                                { 0, 3, 7, 6 }, { 0, 7, 4, 6 },
                                                                { 0, 4, 5, 6 }, { 0, 5, 1, 6 } } },
    { 5,
      { { 0, 4, 7, 3, 8 }, { 1, 2, 6, 5, 8 }, { 0, 1, 5, 4, 8 }, { 3, 7, 6, 2, 8 },
        { 0, 3, 2, 1, 8 }, { 4, 5, 6, 7, 8 } } },
    { 6, { { 0, 1, 2, 4, 5, 6 }, { 0, 2, 3, 4, 6, 7 } } }, { 8, { { 0, 1, 2, 3, 4, 5, 6, 7 } } } };
  std::vector<Corners> result;
  for (const std::vector<int>& cell : cells.at(shape))
  {
    Corners corners;
    for (int corner : cell)
    {
      corners.push_back(c[corner]);
    }
    result.push_back(corners);
  }
  return result;
}

// Shape functions of the linear cell with this many corners.
RelevoPosition Place(const Corners& corners, const double* pc)
{
  const double r = pc[0];
  const double s = pc[1];
  const double t = pc[2];
  std::vector<double> shares;
  switch (corners.size())
  {
    case 4:
      shares = { 1.0 - r - s - t, r, s, t };
      break;
    case 5:
      shares = { (1 - r) * (1 - s) * (1 - t), r * (1 - s) * (1 - t), r * s * (1 - t),
        (1 - r) * s * (1 - t), t };
      break;
    case 6:
      shares = { (1 - r - s) * (1 - t), r * (1 - t), s * (1 - t), (1 - r - s) * t, r * t, s * t };
      break;
    default:
      shares = { (1 - r) * (1 - s) * (1 - t), r * (1 - s) * (1 - t), r * s * (1 - t),
        (1 - r) * s * (1 - t), (1 - r) * (1 - s) * t, r * (1 - s) * t, r * s * t, (1 - r) * s * t };
  }
  RelevoPosition x{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      x[c] += shares[i] * corners[i][c];
    }
  }
  return x;
}

// 3 x 3 x 3 bent cubes of cells of one type.
vtkSmartPointer<vtkUnstructuredGrid> NewBlock(int type, int degree, int shape, vtkIdType nodes)
{
  const std::array<int, 3> degrees{ degree, degree, degree };
  auto sample = RelevoNewCell(type, degrees, 0.0, false, nodes);
  const vtkIdType number = sample->GetCell(0)->GetNumberOfPoints();
  const std::vector<double> parametric(sample->GetCell(0)->GetParametricCoords(),
    sample->GetCell(0)->GetParametricCoords() + 3 * number);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  grid->Allocate(27);
  std::map<std::array<long, 3>, vtkIdType> known;
  for (int cube = 0; cube < 27; ++cube)
  {
    for (const Corners& corners : SplitCube(shape))
    {
      std::vector<vtkIdType> ids;
      for (vtkIdType i = 0; i < number; ++i)
      {
        RelevoPosition x = Place(corners, &parametric[3 * i]);
        x = { x[0] + cube % 3, x[1] + cube / 3 % 3, x[2] + cube / 9 };
        const std::array<long, 3> key{ std::lround(x[0] * 1e6), std::lround(x[1] * 1e6),
          std::lround(x[2] * 1e6) };
        const auto [point, isNew] = known.insert({ key, points->GetNumberOfPoints() });
        if (isNew)
        {
          points->InsertNextPoint(Bend(x).data());
        }
        ids.push_back(point->second);
      }
      grid->InsertNextCell(type, number, ids.data());
    }
  }
  return grid;
}

void TestBlock(RelevoCheck& check, int type, int degree, int shape, vtkIdType nodes = 0)
{
  auto mesh = RelevoMakePatches(NewBlock(type, degree, shape, nodes));
  const int expected = shape == 4 ? 108 : (shape == 6 ? 72 : 54);
  const std::map<Curve, int> borders = CountBorders(mesh);
  const bool isClosed = std::all_of(
    borders.begin(), borders.end(), [](const auto& border) { return border.second == 2; });
  if (RelevoGetNumberOfPatches(mesh) != expected || !isClosed)
  {
    std::cerr << "type " << type << ", degree " << degree << ": " << RelevoGetNumberOfPatches(mesh)
              << " patches of " << expected << (isClosed ? "" : ", not closed") << "\n";
  }
  CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), expected);
  CHECK(isClosed);
}

void TestBlocks(RelevoCheck& check)
{
  TestBlock(check, VTK_TETRA, 1, 4);
  TestBlock(check, VTK_PYRAMID, 1, 5);
  TestBlock(check, VTK_WEDGE, 1, 6);
  TestBlock(check, VTK_HEXAHEDRON, 1, 8);
  TestBlock(check, VTK_QUADRATIC_TETRA, 2, 4);
  TestBlock(check, VTK_QUADRATIC_PYRAMID, 2, 5);
  TestBlock(check, VTK_QUADRATIC_WEDGE, 2, 6);
  TestBlock(check, VTK_BIQUADRATIC_QUADRATIC_WEDGE, 2, 6);
  TestBlock(check, VTK_QUADRATIC_LINEAR_WEDGE, 2, 6);
  TestBlock(check, VTK_QUADRATIC_HEXAHEDRON, 2, 8);
  TestBlock(check, VTK_TRIQUADRATIC_HEXAHEDRON, 2, 8);
  TestBlock(check, VTK_LAGRANGE_TETRAHEDRON, 2, 4, 15);
  for (int degree : { 1, 2, 3, 5, 8 })
  {
    CHECK_CASE(degree);
    TestBlock(check, VTK_LAGRANGE_TETRAHEDRON, degree, 4);
    TestBlock(check, VTK_LAGRANGE_WEDGE, degree, 6);
    TestBlock(check, VTK_LAGRANGE_HEXAHEDRON, degree, 8);
    TestBlock(check, VTK_BEZIER_TETRAHEDRON, degree, 4);
    TestBlock(check, VTK_BEZIER_WEDGE, degree, 6);
    TestBlock(check, VTK_BEZIER_HEXAHEDRON, degree, 8);
  }
}

// Adds a cell whose nodes `common` are existing points, in this order.
void Join(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* other,
  const std::vector<vtkIdType>& nodes, const std::vector<vtkIdType>& common)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    const auto found = std::find(nodes.begin(), nodes.end(), i);
    ids.push_back(found == nodes.end() ? grid->GetPoints()->InsertNextPoint(other->GetPoint(i))
                                       : common[found - nodes.begin()]);
  }
  grid->InsertNextCell(other->GetCellType(0), static_cast<vtkIdType>(ids.size()), ids.data());
}

std::vector<vtkIdType> GetTriangleEdge(int degree, int edge)
{
  std::vector<vtkIdType> nodes;
  for (int k = 0; k <= degree; ++k)
  {
    std::array<vtkIdType, 3> index{ 0, 0, 0 };
    index[edge] = k;
    index[(edge + 1) % 3] = degree - k;
    nodes.push_back(vtkHigherOrderTriangle::Index(index.data(), degree));
  }
  return nodes;
}

// A Lagrange quadrilateral beside a triangle of the same degree, in all orientations.
void TestDegrees(RelevoCheck& check)
{
  for (int degree = 1; degree <= 8; ++degree)
  {
    const std::array<int, 3> degrees{ degree, degree, degree };
    for (int way = 0; way < 6; ++way)
    {
      auto grid = RelevoNewCell(VTK_LAGRANGE_QUADRILATERAL, degrees, 0.1);
      grid->GetCellData()->Initialize();
      grid->GetPointData()->Initialize();
      std::vector<vtkIdType> common;
      for (int k = 0; k <= degree; ++k)
      {
        common.push_back(vtkHigherOrderQuadrilateral::PointIndexFromIJK(
          way % 2 ? k : 0, way % 2 ? degree : k, degrees.data()));
      }
      if (way >= 3)
      {
        std::reverse(common.begin(), common.end());
      }
      Join(grid, RelevoNewCell(VTK_LAGRANGE_TRIANGLE, degrees, 0.1),
        GetTriangleEdge(degree, way % 3), common);
      auto mesh = RelevoMakePatches(grid);
      CHECK_EQUAL(CountBorders(mesh).size(), 6);
    }
  }
}

// Quadratic cells of different kinds around an edge. One of them becomes a patch of degree 3.
void TestQuadratic(RelevoCheck& check)
{
  auto grid = RelevoNewCell(VTK_QUADRATIC_QUAD, { 2, 2, 2 }, 0.1);
  grid->GetPointData()->Initialize();
  const std::vector<vtkIdType> edge{ 0, 4, 1 };
  for (int type : { VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_LINEAR_QUAD,
         VTK_BIQUADRATIC_TRIANGLE })
  {
    CHECK_CASE(type);
    const bool isTriangle = type == VTK_QUADRATIC_TRIANGLE || type == VTK_BIQUADRATIC_TRIANGLE;
    Join(grid, RelevoNewCell(type, { 2, 2, 2 }, 0.1),
      isTriangle ? std::vector<vtkIdType>{ 1, 3, 0 } : edge, edge);
    const std::map<Curve, int> borders = CountBorders(RelevoMakePatches(grid));
    const auto most = std::max_element(borders.begin(), borders.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    CHECK_EQUAL(most->second, grid->GetNumberOfCells());
  }
}
}

int TestPatchSurfaceNeighbours(int, char*[])
{
  RelevoCheck check;
  TestBlocks(check);
  TestDegrees(check);
  TestQuadratic(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/FaceCells.h"

#include "Cells/CellReader.h"
#include "Cells/FaceNodes.h"
#include "vtkCellType.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTriangle.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace relevo
{
namespace
{
FaceCell MakePolygon(const CellReader& cell, int face)
{
  std::vector<vtkIdType> points = cell.GetCorners(face);
  if (cell.IsInsideOut())
  {
    std::reverse(points.begin() + 1, points.end());
  }
  const int type = points.size() == 3 ? VTK_TRIANGLE : VTK_POLYGON;
  return { cell.GetCell(), type, ivec2(1), std::move(points) };
}

// Return VTK's index of a node in a cell of any degree.
vtkIdType GetIndex(const NodeNet& net, int i, int j)
{
  const std::array<int, 4> order{ net.Degrees.x, net.Degrees.y, 0, 0 };
  if (!net.IsTriangle)
  {
    return vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, order.data());
  }
  const std::array<vtkIdType, 3> index{ i, j, order[0] - i - j };
  return vtkHigherOrderTriangle::Index(index.data(), order[0]);
}

int GetCurvedType(const NodeNet& net)
{
  if (net.Basis == NodeBasis::Bezier)
  {
    return net.IsTriangle ? VTK_BEZIER_TRIANGLE : VTK_BEZIER_QUADRILATERAL;
  }
  return net.IsTriangle ? VTK_LAGRANGE_TRIANGLE : VTK_LAGRANGE_QUADRILATERAL;
}

FaceCell MakeCell(const NodeNet& net, const vtkIdType* nodes)
{
  const auto select = [nodes](std::initializer_list<int> order)
  {
    std::vector<vtkIdType> points;
    std::transform(order.begin(), order.end(), std::back_inserter(points),
      [nodes](int node) { return nodes[node]; });
    return points;
  };
  if (net.Basis == NodeBasis::Serendipity)
  {
    return { net.Cell, VTK_QUADRATIC_QUAD, net.Degrees, select({ 0, 2, 8, 6, 1, 5, 7, 3 }) };
  }
  if (net.Basis == NodeBasis::Bubble)
  {
    return { net.Cell, VTK_BIQUADRATIC_TRIANGLE, net.Degrees, select({ 0, 2, 5, 1, 4, 3, 6 }) };
  }
  if (net.Basis == NodeBasis::Lagrange && net.Degrees == ivec2(1))
  {
    return net.IsTriangle ? FaceCell{ net.Cell, VTK_TRIANGLE, net.Degrees, select({ 0, 1, 2 }) }
                          : FaceCell{ net.Cell, VTK_QUAD, net.Degrees, select({ 0, 1, 3, 2 }) };
  }
  FaceCell cell{ net.Cell, GetCurvedType(net), net.Degrees, {} };
  std::size_t number = 0;
  for (int j = 0; j <= net.Degrees.y; ++j)
  {
    for (int i = 0; i <= (net.IsTriangle ? net.Degrees.x - j : net.Degrees.x); ++i, ++number)
    {
      const auto index = static_cast<std::size_t>(GetIndex(net, i, j));
      cell.Points.resize(std::max(cell.Points.size(), index + 1));
      cell.Points[index] = nodes[number];
    }
  }
  return cell;
}
}

std::vector<FaceCell> MakeFaceCells(vtkUnstructuredGrid* grid, const std::vector<CellFace>& faces)
{
  std::vector<FaceCell> cells;
  std::vector<CellFace> others; // that are not polygons
  CellReader reader(grid);
  bool isNew = true;
  for (const CellFace& face : faces)
  {
    if (isNew || reader.GetCell() != face.Cell)
    {
      isNew = false;
      reader.Read(face.Cell);
    }
    if (IsPolygon(reader, face.Face))
    {
      cells.push_back(MakePolygon(reader, face.Face));
    }
    else
    {
      others.push_back(face);
    }
  }
  const NodeNets nets = CollectNodes(grid, others);
  for (const NodeNet& net : nets.Nets)
  {
    cells.push_back(MakeCell(net, nets.Nodes.data() + net.First));
  }
  std::stable_sort(cells.begin(), cells.end(),
    [](const FaceCell& a, const FaceCell& b) { return a.Cell < b.Cell; });
  return cells;
}
}

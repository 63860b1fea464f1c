// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/FaceNodes.h"

#include "Cells/CellReader.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace relevo
{
namespace
{
// Returns VTK's index of the node at these steps along the parametric axes of the cell.
vtkIdType GetNodeNumber(CellTopology shape, const ivec3& degrees, const ivec3& steps)
{
  const std::array<int, 4> order{ degrees.x, degrees.y, degrees.z, 0 };
  const vtkIdType rest = degrees.x - steps.x - steps.y;
  switch (shape)
  {
    case CellTopology::Triangle:
    {
      const std::array<vtkIdType, 3> index{ steps.x, steps.y, rest };
      return vtkHigherOrderTriangle::Index(index.data(), degrees.x);
    }
    case CellTopology::Tetrahedron:
    {
      const std::array<vtkIdType, 4> index{ steps.x, steps.y, steps.z, rest - steps.z };
      return vtkHigherOrderTetra::Index(index.data(), degrees.x);
    }
    case CellTopology::Quadrilateral:
      return vtkHigherOrderQuadrilateral::PointIndexFromIJK(steps.x, steps.y, order.data());
    case CellTopology::Wedge:
      return vtkHigherOrderWedge::PointIndexFromIJK(steps.x, steps.y, steps.z, order.data());
    default:
      return vtkHigherOrderHexahedron::PointIndexFromIJK(steps.x, steps.y, steps.z, order.data());
  }
}

// Whether two points of a polygon are adjacent.
bool IsEdge(const std::vector<vtkIdType>& polygon, vtkIdType a, vtkIdType b)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const vtkIdType from = polygon[i];
    const vtkIdType to = polygon[(i + 1) % polygon.size()];
    if ((from == a && to == b) || (from == b && to == a))
    {
      return true;
    }
  }
  return false;
}

class NodeCollector
{
public:
  explicit NodeCollector(vtkUnstructuredGrid* grid)
    : Cell(grid)
    , Grid(grid)
  {
  }

  void Add(const CellFace& face)
  {
    if (this->IsNew || this->Cell.GetCell() != face.Cell)
    {
      this->IsNew = false;
      this->Cell.Read(face.Cell);
      this->IsInsideOut = this->Cell.IsInsideOut();
    }
    if (IsPolygon(this->Cell, face.Face))
    {
      this->AddPolygon(this->Cell.GetCorners(face.Face));
      return;
    }
    CornerNodes corners = this->Cell.GetCornerNodes(face.Face);
    if (this->IsInsideOut)
    {
      std::reverse(corners.Corners.begin() + 1, corners.Corners.begin() + corners.Size);
    }
    switch (this->Cell.GetKind().Nodes)
    {
      case NodeKind::Corners:
        this->AddLinear(corners);
        break;
      case NodeKind::Quadratic:
        this->AddQuadratic(corners, this->Cell.GetKind().FaceNodes[face.Face]);
        break;
      default:
        this->AddHigherOrder(corners);
    }
  }

  NodeNets Result;

private:
  void AddNet(const ivec2& degrees, bool isTriangle, NodeBasis basis)
  {
    this->Result.Nets.push_back({ this->Cell.GetCell(),
      static_cast<vtkIdType>(this->Result.Nodes.size()), degrees, isTriangle, basis, 0 });
  }

  void AddNode(vtkIdType node) { this->Result.Nodes.push_back(this->Cell.GetNode(node)); }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->AddNet(ivec2(1), true, NodeBasis::Lagrange);
    this->Result.Nodes.insert(this->Result.Nodes.end(), { a, b, c });
  }

  // Adds a triangle of a polygon, whose borders may be inside of the polygon.
  void AddPart(const std::vector<vtkIdType>& polygon, const std::array<vtkIdType, 3>& corners)
  {
    this->AddTriangle(corners[0], corners[1], corners[2]);
    const std::array<std::array<int, 2>, 3> borders{ { { 0, 1 }, { 0, 2 }, { 1, 2 } } };
    for (int border = 0; border < 3; ++border)
    {
      const bool isEdge = IsEdge(polygon, corners[borders[border][0]], corners[borders[border][1]]);
      this->Result.Nets.back().InnerBorders |= isEdge ? 0 : 1 << border;
    }
  }

  void AddPolygon(std::vector<vtkIdType> points)
  {
    if (this->IsInsideOut)
    {
      std::reverse(points.begin() + 1, points.end());
    }
    if (points.size() == 3)
    {
      this->AddTriangle(points[0], points[1], points[2]);
      return;
    }
    this->Polygon->PointIds->Reset();
    this->Polygon->Points->Reset();
    for (vtkIdType point : points)
    {
      double x[3];
      this->Grid->GetPoint(point, x);
      this->Polygon->PointIds->InsertNextId(point);
      this->Polygon->Points->InsertNextPoint(x);
    }
    const vtkIdType triangles = static_cast<vtkIdType>(points.size()) - 2;
    vtkCell* polygon = this->Polygon;
    polygon->Triangulate(0, this->Triangles, this->TrianglePoints);
    const bool isWhole = this->Triangles->GetNumberOfIds() == 3 * triangles;
    for (vtkIdType i = 0; i < triangles; ++i)
    {
      const vtkIdType* ids = isWhole ? this->Triangles->GetPointer(3 * i) : nullptr;
      this->AddPart(points,
        ids ? std::array<vtkIdType, 3>{ ids[0], ids[1], ids[2] }
            : std::array<vtkIdType, 3>{ points[0], points[i + 1], points[i + 2] });
    }
  }

  void AddLinear(const CornerNodes& corners)
  {
    // A quadrilateral has the rows (0, 1) and (3, 2).
    const std::array<int, 4> order{ 0, 1, corners.Size == 3 ? 2 : 3, 2 };
    this->AddNet(ivec2(1), corners.Size == 3, NodeBasis::Lagrange);
    for (int k = 0; k < corners.Size; ++k)
    {
      this->AddNode(corners.Corners[order[k]]);
    }
  }

  void AddQuadratic(const CornerNodes& face, int middle)
  {
    const auto& c = face.Corners;
    const auto getEdge = [&](int k)
    { return GetEdgeNode(this->Cell.GetKind(), c[k], c[(k + 1) % face.Size]); };
    if (face.Size == 3)
    {
      this->AddNet(ivec2(2), true, middle ? NodeBasis::Bubble : NodeBasis::Lagrange);
      for (int node : { c[0], getEdge(0), c[1], getEdge(2), getEdge(1), c[2] })
      {
        this->AddNode(node);
      }
      if (middle)
      {
        this->AddNode(middle);
      }
      return;
    }
    const bool isQuadraticU = getEdge(0) != 0;
    const bool isQuadraticV = getEdge(1) != 0;
    const bool hasMiddle = isQuadraticU && isQuadraticV;
    this->AddNet(ivec2(1 + isQuadraticU, 1 + isQuadraticV), false,
      hasMiddle && !middle ? NodeBasis::Serendipity : NodeBasis::Lagrange);
    const std::array<std::array<int, 3>, 3> rows{ { { c[0], getEdge(0), c[1] },
      { getEdge(3), middle, getEdge(1) }, { c[3], getEdge(2), c[2] } } };
    for (int j = 0; j < 3; j += 1 + !isQuadraticV)
    {
      for (int i = 0; i < 3; i += 1 + !isQuadraticU)
      {
        this->AddNode(rows[j][i]);
      }
    }
  }

  void AddHigherOrder(const CornerNodes& face)
  {
    const CellTopology shape = this->Cell.GetKind().Shape;
    const ivec3 degrees = this->Cell.GetDegrees();
    const ivec3 origin = GetCornerCoordinates(shape, face.Corners[0]);
    const ivec3 u = GetCornerCoordinates(shape, face.Corners[1]) - origin;
    const ivec3 v = GetCornerCoordinates(shape, face.Corners[face.Size - 1]) - origin;
    const auto getDegree = [&](const ivec3& axis)
    { return degrees[axis.x != 0 ? 0 : (axis.y != 0 ? 1 : 2)]; };
    const ivec2 size(getDegree(u), getDegree(v));
    const bool isTriangle = face.Size == 3;
    const bool isBezier = this->Cell.GetKind().Nodes == NodeKind::Bezier;
    this->AddNet(size, isTriangle, isBezier ? NodeBasis::Bezier : NodeBasis::Lagrange);
    for (int j = 0; j <= size.y; ++j)
    {
      for (int i = 0; i <= (isTriangle ? size.x - j : size.x); ++i)
      {
        this->AddNode(GetNodeNumber(shape, degrees, origin * degrees + i * u + j * v));
      }
    }
  }

  CellReader Cell;
  vtkUnstructuredGrid* Grid;
  bool IsNew = true;
  bool IsInsideOut = false;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Triangles;
  vtkNew<vtkPoints> TrianglePoints;
};
}

bool IsPolygon(const CellReader& cell, int face)
{
  const CellTopology shape = cell.GetKind().Shape;
  return shape == CellTopology::Polygon || shape == CellTopology::TriangleStrip ||
    shape == CellTopology::Polyhedron || cell.GetCorners(face).size() > 4;
}

NodeNets CollectNodes(vtkUnstructuredGrid* grid, const std::vector<CellFace>& faces)
{
  NodeCollector collector(grid);
  for (const CellFace& face : faces)
  {
    collector.Add(face);
  }
  return std::move(collector.Result);
}
}

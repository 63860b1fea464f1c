// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellKind.h"

#include "vtkCellType.h"

#include <vector>

namespace relevo
{
namespace
{
constexpr std::array<int, 8> PixelOrder{ 0, 1, 3, 2, 4, 5, 7, 6 };

// Edges are in the order of their midpoint nodes, which follow the corners.
struct Topology
{
  int NumberOfCorners = 0;
  std::vector<CornerNodes> Faces;
  std::vector<std::array<int, 2>> Edges;
};

const Topology& GetTopology(CellTopology shape)
{
  static const Topology none;
  static const Topology triangle{ 3, { { 3, { 0, 1, 2 } } }, { { 0, 1 }, { 1, 2 }, { 2, 0 } } };
  static const Topology quadrilateral{ 4, { { 4, { 0, 1, 2, 3 } } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } };
  static const Topology tetrahedron{ 4,
    { { 3, { 0, 1, 3 } }, { 3, { 1, 2, 3 } }, { 3, { 2, 0, 3 } }, { 3, { 0, 2, 1 } } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } } };
  static const Topology hexahedron{ 8,
    { { 4, { 0, 4, 7, 3 } }, { 4, { 1, 2, 6, 5 } }, { 4, { 0, 1, 5, 4 } }, { 4, { 3, 7, 6, 2 } },
      { 4, { 0, 3, 2, 1 } }, { 4, { 4, 5, 6, 7 } } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 },
      { 1, 5 }, { 2, 6 }, { 3, 7 } } };
  static const Topology wedge{ 6,
    { { 3, { 0, 2, 1 } }, { 3, { 3, 4, 5 } }, { 4, { 0, 1, 4, 3 } }, { 4, { 1, 2, 5, 4 } },
      { 4, { 2, 0, 3, 5 } } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } } };
  static const Topology pyramid{ 5,
    { { 4, { 0, 3, 2, 1 } }, { 3, { 0, 1, 4 } }, { 3, { 1, 2, 4 } }, { 3, { 2, 3, 4 } },
      { 3, { 3, 0, 4 } } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } } };
  static const Topology pentagonalPrism{ 10,
    { { 5, { 0, 4, 3, 2, 1 } }, { 5, { 5, 6, 7, 8, 9 } }, { 4, { 0, 1, 6, 5 } },
      { 4, { 1, 2, 7, 6 } }, { 4, { 2, 3, 8, 7 } }, { 4, { 3, 4, 9, 8 } }, { 4, { 4, 0, 5, 9 } } },
    {} };
  static const Topology hexagonalPrism{ 12,
    { { 6, { 0, 5, 4, 3, 2, 1 } }, { 6, { 6, 7, 8, 9, 10, 11 } }, { 4, { 0, 1, 7, 6 } },
      { 4, { 1, 2, 8, 7 } }, { 4, { 2, 3, 9, 8 } }, { 4, { 3, 4, 10, 9 } }, { 4, { 4, 5, 11, 10 } },
      { 4, { 5, 0, 6, 11 } } },
    {} };
  switch (shape)
  {
    case CellTopology::Triangle:
      return triangle;
    case CellTopology::Quadrilateral:
      return quadrilateral;
    case CellTopology::Tetrahedron:
      return tetrahedron;
    case CellTopology::Hexahedron:
      return hexahedron;
    case CellTopology::Wedge:
      return wedge;
    case CellTopology::Pyramid:
      return pyramid;
    case CellTopology::PentagonalPrism:
      return pentagonalPrism;
    case CellTopology::HexagonalPrism:
      return hexagonalPrism;
    default:
      return none;
  }
}

CellKind MakeLinear(CellTopology shape, bool isInPixelOrder = false)
{
  return { shape, NodeKind::Corners, GetTopology(shape).NumberOfCorners, 0, isInPixelOrder, 0, {} };
}

CellKind MakeOfMany(CellTopology shape, int minimumNodes)
{
  return { shape, NodeKind::Corners, 0, minimumNodes, false, 0, {} };
}

CellKind MakeQuadratic(
  CellTopology shape, int nodes, int edgeNodes, const std::array<int, 6>& faceNodes = {})
{
  return { shape, NodeKind::Quadratic, nodes, 0, false, edgeNodes, faceNodes };
}

CellKind MakeHigherOrder(CellTopology shape, NodeKind nodes)
{
  return { shape, nodes, 0, 0, false, 0, {} };
}

CellKind GetQuadraticKind(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_TRIANGLE:
      return MakeQuadratic(CellTopology::Triangle, 6, 3);
    case VTK_BIQUADRATIC_TRIANGLE:
      return MakeQuadratic(CellTopology::Triangle, 7, 3, { 6 });
    case VTK_QUADRATIC_LINEAR_QUAD:
      return MakeQuadratic(CellTopology::Quadrilateral, 6, 2);
    case VTK_QUADRATIC_QUAD:
      return MakeQuadratic(CellTopology::Quadrilateral, 8, 4);
    case VTK_BIQUADRATIC_QUAD:
      return MakeQuadratic(CellTopology::Quadrilateral, 9, 4, { 8 });
    case VTK_QUADRATIC_TETRA:
      return MakeQuadratic(CellTopology::Tetrahedron, 10, 6);
    case VTK_QUADRATIC_HEXAHEDRON:
      return MakeQuadratic(CellTopology::Hexahedron, 20, 12);
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
      return MakeQuadratic(CellTopology::Hexahedron, 24, 12, { 20, 21, 22, 23 });
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      return MakeQuadratic(CellTopology::Hexahedron, 27, 12, { 20, 21, 22, 23, 24, 25 });
    case VTK_QUADRATIC_LINEAR_WEDGE:
      return MakeQuadratic(CellTopology::Wedge, 12, 6);
    case VTK_QUADRATIC_WEDGE:
      return MakeQuadratic(CellTopology::Wedge, 15, 9);
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
      return MakeQuadratic(CellTopology::Wedge, 18, 9, { 0, 0, 15, 16, 17 });
    case VTK_QUADRATIC_PYRAMID:
      return MakeQuadratic(CellTopology::Pyramid, 13, 8);
    case VTK_TRIQUADRATIC_PYRAMID:
      return MakeQuadratic(CellTopology::Pyramid, 19, 8, { 13, 14, 15, 16, 17 });
    default:
      return {};
  }
}

CellKind GetHigherOrderKind(int type, vtkIdType nodes)
{
  switch (type)
  {
    case VTK_LAGRANGE_TRIANGLE:
      return nodes == 7 ? GetQuadraticKind(VTK_BIQUADRATIC_TRIANGLE)
                        : MakeHigherOrder(CellTopology::Triangle, NodeKind::Lagrange);
    case VTK_LAGRANGE_QUADRILATERAL:
      return MakeHigherOrder(CellTopology::Quadrilateral, NodeKind::Lagrange);
    case VTK_LAGRANGE_TETRAHEDRON:
      return nodes == 15 ? MakeQuadratic(CellTopology::Tetrahedron, 15, 6, { 11, 12, 13, 10 })
                         : MakeHigherOrder(CellTopology::Tetrahedron, NodeKind::Lagrange);
    case VTK_LAGRANGE_HEXAHEDRON:
      return MakeHigherOrder(CellTopology::Hexahedron, NodeKind::Lagrange);
    case VTK_LAGRANGE_WEDGE:
      return nodes == 21 ? MakeQuadratic(CellTopology::Wedge, 21, 9, { 15, 16, 17, 18, 19 })
                         : MakeHigherOrder(CellTopology::Wedge, NodeKind::Lagrange);
    case VTK_BEZIER_TRIANGLE:
      return MakeHigherOrder(CellTopology::Triangle, NodeKind::Bezier);
    case VTK_BEZIER_QUADRILATERAL:
      return MakeHigherOrder(CellTopology::Quadrilateral, NodeKind::Bezier);
    case VTK_BEZIER_TETRAHEDRON:
      return MakeHigherOrder(CellTopology::Tetrahedron, NodeKind::Bezier);
    case VTK_BEZIER_HEXAHEDRON:
      return MakeHigherOrder(CellTopology::Hexahedron, NodeKind::Bezier);
    case VTK_BEZIER_WEDGE:
      return MakeHigherOrder(CellTopology::Wedge, NodeKind::Bezier);
    default:
      return {};
  }
}

CellKind MakeCurve(int nodes, int minimumNodes)
{
  return { CellTopology::Curve, NodeKind::Corners, nodes, minimumNodes, false, 0, {} };
}

CellKind GetThinKind(int type)
{
  switch (type)
  {
    case VTK_EMPTY_CELL:
      return MakeOfMany(CellTopology::Empty, 0);
    case VTK_VERTEX:
      return { CellTopology::Points, NodeKind::Corners, 1, 0, false, 0, {} };
    case VTK_POLY_VERTEX:
      return MakeOfMany(CellTopology::Points, 1);
    case VTK_LINE:
      return MakeCurve(2, 0);
    case VTK_POLY_LINE:
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return MakeCurve(0, 2);
    case VTK_QUADRATIC_EDGE:
      return MakeCurve(3, 0);
    case VTK_CUBIC_LINE:
      return MakeCurve(4, 0);
    default:
      return {};
  }
}

CellKind GetLinearKind(int type)
{
  switch (type)
  {
    case VTK_TRIANGLE:
      return MakeLinear(CellTopology::Triangle);
    case VTK_PIXEL:
      return MakeLinear(CellTopology::Quadrilateral, true);
    case VTK_QUAD:
      return MakeLinear(CellTopology::Quadrilateral);
    case VTK_POLYGON:
      return MakeOfMany(CellTopology::Polygon, 3);
    case VTK_TRIANGLE_STRIP:
      return MakeOfMany(CellTopology::TriangleStrip, 3);
    case VTK_QUADRATIC_POLYGON:
      return MakeOfMany(CellTopology::QuadraticPolygon, 6);
    case VTK_TETRA:
      return MakeLinear(CellTopology::Tetrahedron);
    case VTK_VOXEL:
      return MakeLinear(CellTopology::Hexahedron, true);
    case VTK_HEXAHEDRON:
      return MakeLinear(CellTopology::Hexahedron);
    case VTK_WEDGE:
      return MakeLinear(CellTopology::Wedge);
    case VTK_PYRAMID:
      return MakeLinear(CellTopology::Pyramid);
    case VTK_PENTAGONAL_PRISM:
      return MakeLinear(CellTopology::PentagonalPrism);
    case VTK_HEXAGONAL_PRISM:
      return MakeLinear(CellTopology::HexagonalPrism);
    case VTK_POLYHEDRON:
      return MakeOfMany(CellTopology::Polyhedron, 4);
    case VTK_CONVEX_POINT_SET:
      return MakeOfMany(CellTopology::PointSet, 4);
    default:
      return {};
  }
}
}

CellKind GetCellKind(int type, vtkIdType nodes)
{
  CellKind kind = GetLinearKind(type);
  if (kind.Shape == CellTopology::Unknown)
  {
    kind = GetQuadraticKind(type);
  }
  if (kind.Shape == CellTopology::Unknown)
  {
    kind = GetThinKind(type);
  }
  return kind.Shape == CellTopology::Unknown ? GetHigherOrderKind(type, nodes) : kind;
}

int GetNumberOfFaces(CellTopology shape)
{
  return static_cast<int>(GetTopology(shape).Faces.size());
}

CornerNodes GetFace(CellTopology shape, int face)
{
  return GetTopology(shape).Faces[face];
}

CornerNodes GetFaceNodes(const CellKind& kind, int face)
{
  CornerNodes nodes = GetFace(kind.Shape, face);
  for (int k = 0; k < nodes.Size && kind.IsInPixelOrder; ++k)
  {
    nodes.Corners[k] = PixelOrder[nodes.Corners[k]];
  }
  return nodes;
}

int GetEdgeNode(const CellKind& kind, int first, int second)
{
  // QuadraticLinearQuad has nodes on edges 0 and 2.
  const int step = kind.Shape == CellTopology::Quadrilateral && kind.NumberOfEdgeNodes == 2 ? 2 : 1;
  const Topology& topology = GetTopology(kind.Shape);
  for (int i = 0; i < kind.NumberOfEdgeNodes; ++i)
  {
    const std::array<int, 2>& edge = topology.Edges[i * step];
    if ((edge[0] == first && edge[1] == second) || (edge[0] == second && edge[1] == first))
    {
      return topology.NumberOfCorners + i;
    }
  }
  return 0;
}

ivec3 GetCornerCoordinates(CellTopology shape, int corner)
{
  if (shape == CellTopology::Tetrahedron && corner == 3)
  {
    return ivec3(0, 0, 1);
  }
  const bool isTriangular = shape == CellTopology::Triangle || shape == CellTopology::Tetrahedron ||
    shape == CellTopology::Wedge;
  const int size = isTriangular ? 3 : 4;
  const int k = corner % size;
  const ivec2 plane = isTriangular ? ivec2(k == 1, k == 2) : ivec2(k == 1 || k == 2, k >= 2);
  return ivec3(plane, corner / size);
}
}

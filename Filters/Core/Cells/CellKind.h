// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the faces and nodes of VTK's cell types
 */
#ifndef CellKind_h
#define CellKind_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"

#include <array>

namespace relevo
{
enum class CellTopology
{
  Unknown, // VTK has no cell of this type
  Empty,
  Points,
  Curve,
  Triangle,
  Quadrilateral,
  Polygon,
  TriangleStrip,
  QuadraticPolygon,
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid,
  PentagonalPrism,
  HexagonalPrism,
  Polyhedron,
  PointSet // convex
};

enum class NodeKind
{
  Corners,   // linear
  Quadratic, // nodes at midpoints of edges, optionally of faces
  Lagrange,  // any degree
  Bezier
};

constexpr int MaximumFaceCorners = 6;

/// Nodes at the corners of a face, counter-clockwise from outside.
struct CornerNodes
{
  int Size;
  std::array<int, MaximumFaceCorners> Corners;
};

struct CellKind
{
  CellTopology Shape = CellTopology::Unknown;
  NodeKind Nodes = NodeKind::Corners;
  int NumberOfNodes = 0;          // 0 if it varies
  int MinimumNodes = 0;           // for types with neither a fixed number of nodes nor a degree
  bool IsInPixelOrder = false;    // corners are ordered as in VTK_PIXEL and VTK_VOXEL
  int NumberOfEdgeNodes = 0;      // on the first edges of the shape
  std::array<int, 6> FaceNodes{}; // the node at the centre of each face; 0 if there is none

  bool IsSolid() const { return this->Shape >= CellTopology::Tetrahedron; }
  bool IsSurface() const
  {
    return this->Shape >= CellTopology::Triangle && this->Shape <= CellTopology::QuadraticPolygon;
  }
};

/// `nodes` is the cell's number of nodes. Some Lagrange types with few nodes are quadratic cells
/// with face nodes.
RELEVOFILTERSCORE_EXPORT CellKind GetCellKind(int type, vtkIdType nodes);

/// Whether the shape is a simplex, which has the same degree in all directions.
constexpr bool IsSimplex(CellTopology shape)
{
  return shape == CellTopology::Triangle || shape == CellTopology::Tetrahedron;
}

/// The number of faces of a shape with a fixed number; 1 for a triangle.
RELEVOFILTERSCORE_EXPORT int GetNumberOfFaces(CellTopology shape);
RELEVOFILTERSCORE_EXPORT CornerNodes GetFace(CellTopology shape, int face);
/// The same for a kind of cells, whose nodes can be in the order of VTK_VOXEL.
RELEVOFILTERSCORE_EXPORT CornerNodes GetFaceNodes(const CellKind& kind, int face);
/// The node at the midpoint of the edge between two corners; 0 if there is none.
RELEVOFILTERSCORE_EXPORT int GetEdgeNode(const CellKind& kind, int first, int second);
/// The parametric coordinates of a corner, each 0 or 1.
RELEVOFILTERSCORE_EXPORT ivec3 GetCornerCoordinates(CellTopology shape, int corner);
}

#endif

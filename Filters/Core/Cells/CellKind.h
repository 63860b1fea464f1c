// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the faces of VTK's cells, and where they have their nodes
 *
 * Private to the modules' own sources.
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
  Quadratic, // nodes in the middle of edges, maybe of faces
  Lagrange,  // of any degree
  Bezier
};

constexpr int MaximumFaceCorners = 6;

/// Corners of a face, counter-clockwise from outside.
struct FaceCorners
{
  int Size;
  std::array<int, MaximumFaceCorners> Corners;
};

struct CellKind
{
  CellTopology Shape = CellTopology::Unknown;
  NodeKind Nodes = NodeKind::Corners;
  int NumberOfNodes = 0;          // 0 if it is not the same for all
  int MinimumNodes = 0;           // of those without a fixed number or a degree
  bool IsInPixelOrder = false;    // corners are those of VTK_PIXEL and VTK_VOXEL
  int NumberOfEdgeNodes = 0;      // those of the shape's first edges
  std::array<int, 6> FaceNodes{}; // the node in the middle of each face, 0 if there is none

  bool IsSolid() const { return this->Shape >= CellTopology::Tetrahedron; }
  bool IsSurface() const
  {
    return this->Shape >= CellTopology::Triangle && this->Shape <= CellTopology::QuadraticPolygon;
  }
};

/// `nodes` of the cell: some of Lagrange's kinds are quadratic ones with nodes in their faces.
RELEVOFILTERSCORE_EXPORT CellKind GetCellKind(int type, vtkIdType nodes);

/// Whether all degrees of the shape are one.
constexpr bool IsSimplex(CellTopology shape)
{
  return shape == CellTopology::Triangle || shape == CellTopology::Tetrahedron;
}

/// Of shapes that always have the same: 1 for a triangle.
RELEVOFILTERSCORE_EXPORT int GetNumberOfFaces(CellTopology shape);
RELEVOFILTERSCORE_EXPORT FaceCorners GetFace(CellTopology shape, int face);
/// The node in the middle of the edge between two corners, 0 if there is none.
RELEVOFILTERSCORE_EXPORT int GetEdgeNode(const CellKind& kind, int first, int second);
/// Where a corner lies in the cell's parametric coordinates: 0 or 1.
RELEVOFILTERSCORE_EXPORT ivec3 GetCornerCoordinates(CellTopology shape, int corner);
}

#endif

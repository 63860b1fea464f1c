// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the faces of VTK's cells, and where they have their nodes
 *
 * Private to the module's own sources.
 */
#ifndef CellKind_h
#define CellKind_h

#include "Core/RefinementMathematics.h"
#include "vtkType.h"

#include <array>

namespace relevo
{
enum class CellShape
{
  Unknown, // no surface can be made of it
  Thin,    // points and lines
  Triangle,
  Quadrilateral,
  Polygon,
  TriangleStrip,
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid,
  PentagonalPrism,
  HexagonalPrism,
  Polyhedron
};

enum class NodeKind
{
  Corners,   // linear
  Quadratic, // nodes in the middle of edges, maybe of faces
  Lagrange,  // of any degree
  Bezier
};

constexpr int MostFaceCorners = 6;

/// Corners of a face, counter-clockwise from outside.
struct FaceCorners
{
  int Size;
  std::array<int, MostFaceCorners> Corners;
};

struct CellKind
{
  CellShape Shape = CellShape::Unknown;
  NodeKind Nodes = NodeKind::Corners;
  int NumberOfNodes = 0;          // 0 if it is not the same for all
  bool IsInPixelOrder = false;    // corners are those of VTK_PIXEL and VTK_VOXEL
  int NumberOfEdgeNodes = 0;      // those of the shape's first edges
  std::array<int, 6> FaceNodes{}; // the node in the middle of each face, 0 if there is none

  bool IsSolid() const { return this->Shape >= CellShape::Tetrahedron; }
  bool IsSurface() const
  {
    return this->Shape >= CellShape::Triangle && this->Shape <= CellShape::TriangleStrip;
  }
};

/// `nodes` of the cell: some of Lagrange's kinds are quadratic ones with nodes in their faces.
CellKind GetCellKind(int type, vtkIdType nodes);

/// Of shapes that always have the same: 1 for a triangle.
int GetNumberOfFaces(CellShape shape);
FaceCorners GetFace(CellShape shape, int face);
/// The node in the middle of the edge between two corners, 0 if there is none.
int GetEdgeNode(const CellKind& kind, int first, int second);
/// Where a corner lies in the cell's parametric coordinates: 0 or 1.
ivec3 GetCornerCoordinates(CellShape shape, int corner);
}

#endif

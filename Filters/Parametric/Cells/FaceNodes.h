// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   nodes of faces in the order of control points
 *
 * Private to the module.
 */
#ifndef FaceNodes_h
#define FaceNodes_h

#include "Cells/BoundaryFaces.h"
#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
class CellReader;

enum class NodeBasis : unsigned char
{
  Lagrange,
  Serendipity, // biquadratic; the middle node is computed from the others
  Bubble,      // quadratic triangle with an additional middle node, which is last
  Bezier
};

/// A face, or a triangle that is part of one.
struct NodeNet
{
  vtkIdType Cell;
  vtkIdType First; // index of the first node in NodeNets
  ivec2 Degrees;   // both equal for a triangle
  bool IsTriangle;
  NodeBasis Basis;
  int InnerBorders = 0; // see PatchArrays
};

struct NodeNets
{
  std::vector<NodeNet> Nets;
  std::vector<vtkIdType> Nodes;
};

/// Whether a face is a polygon, which is cut into triangles.
bool IsPolygon(const CellReader& cell, int face);

/// Collects the nodes of faces. Nodes of quadrilaterals are rows along u. Nodes of triangles are
/// rows j = 0 to degree of i = 0 to degree - j. u x v points out of 3D cells.
NodeNets CollectNodes(vtkUnstructuredGrid* grid, const std::vector<CellFace>& faces);
}

#endif

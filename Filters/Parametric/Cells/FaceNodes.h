// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the nodes of faces, in the order of a patch's control points
 *
 * Private to the module's own sources.
 */
#ifndef FaceNodes_h
#define FaceNodes_h

#include "Cells/BoundaryFaces.h"
#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
enum class NodeBasis : unsigned char
{
  Lagrange,
  Serendipity, // biquadratic; the node in the middle stands for what the others make of it
  Bubble,      // a quadratic triangle; one node more, last, is in its middle
  Bezier
};

/// A face, or a triangle of one.
struct NodeNet
{
  vtkIdType Cell;
  vtkIdType First; // node, in NodeNets
  ivec2 Degrees;   // of a triangle both the same
  bool IsTriangle;
  NodeBasis Basis;
  int InnerBorders = 0; // see PatchArrays
};

struct NodeNets
{
  std::vector<NodeNet> Nets;
  std::vector<vtkIdType> Nodes;
};

/// Quadrilaterals' nodes are rows along u, triangles' rows j = 0 to degree of i = 0 to degree - j.
/// u x v points out of solid cells.
NodeNets CollectNodes(vtkUnstructuredGrid* grid, const std::vector<CellFace>& faces);
}

#endif

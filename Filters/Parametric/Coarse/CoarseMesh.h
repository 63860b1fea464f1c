// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   coarse triangles of patches
 *
 * Private to the module's own sources.
 */
#ifndef CoarseMesh_h
#define CoarseMesh_h

#include "Cells/ControlNets.h"

#include <array>
#include <vector>

namespace relevo
{
struct CoarsePoint
{
  dvec3 Place;
  vtkIdType GridPoint;   // a node at the place, or one near by
  std::size_t Patch = 0; // where it is no node: in which patch
  dvec2 Coordinates{ 0.0 };
  bool IsNode = true;
};

struct CoarseTriangle
{
  std::size_t Patch;
  std::array<vtkIdType, 3> Points;
  std::array<dvec2, 3> Coordinates;
};

struct CoarseMesh
{
  std::vector<CoarsePoint> Points;
  std::vector<CoarseTriangle> Triangles; // in the order of the patches
  std::vector<dvec3> Normals;            // for each point
};

/// `points` are not multiplied with their weights, `homogeneous` are. Edges are split in
/// `minimumPieces`, 1 or 2, or more.
}

#endif

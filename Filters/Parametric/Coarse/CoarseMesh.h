// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   coarse triangles of patches
 *
 * Private to the module.
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
  vtkIdType GridPoint;   // a node at this position, or a nearby one
  std::size_t Patch = 0; // the patch of a point that is not a node
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
  std::vector<CoarseTriangle> Triangles; // ordered by patch
  std::vector<dvec3> Normals;            // one per point
};

}

#endif

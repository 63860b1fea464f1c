// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that a refined mesh is closed, bit for bit, wherever the coarse mesh is.
#ifndef RelevoWatertight_h
#define RelevoWatertight_h

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace RelevoWatertight
{
using Edge = std::pair<vtkIdType, vtkIdType>;
// How often an edge is used from its lower to its higher end, and in the opposite direction.
using Uses = std::pair<int, int>;
using EdgeUses = std::map<Edge, Uses>;

// The lowest id of a point with the same bytes, or with `value`, with equal coordinates.
std::vector<vtkIdType> Weld(vtkPoints* points, bool value);

void Use(EdgeUses& edges, vtkIdType a, vtkIdType b);

// Triangles of polygons (fans) and strips, without those that have two merged corners.
std::vector<std::array<vtkIdType, 3>> GetTriangles(
  vtkPolyData* mesh, const std::vector<vtkIdType>& places);

// Level of an edge of the coarse mesh by the documentation. Without `tags` it is maximumLevel.
int GetLevel(const std::vector<double>& tags, vtkIdType a, vtkIdType b, int maximumLevel);

// Returns an error message, which is empty if `fine` is a watertight refinement of `coarse`. The
// coarse mesh's points must come first in the fine mesh. If vertices are `morphing`, triangles may
// be empty.
std::string FindError(
  vtkPolyData* coarse, vtkPolyData* fine, int maximumLevel, bool morphing = false);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a refined mesh is closed to the bit wherever the coarse one is.
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
// How often an edge is used from its lower to its higher end, and back.
using Uses = std::pair<int, int>;
using EdgeUses = std::map<Edge, Uses>;

// The lowest point with the same bytes; with `value` the lowest with equal coordinates.
std::vector<vtkIdType> Weld(vtkPoints* points, bool value);

void Use(EdgeUses& edges, vtkIdType a, vtkIdType b);

// Triangles of polygons (fans) and strips, without those that have two corners at one place.
std::vector<std::array<vtkIdType, 3>> GetTriangles(
  vtkPolyData* mesh, const std::vector<vtkIdType>& places);

// Level of an edge of the coarse mesh by the contract's words; `tags` empty: maximumLevel.
int GetLevel(const std::vector<double>& tags, vtkIdType a, vtkIdType b, int maximumLevel);

// Empty when `fine` is a watertight refinement of `coarse`, else what is wrong. The coarse mesh's
// points must be the first of the fine one's. Where vertices are `morphing`, triangles may be
// empty.
std::string FindError(
  vtkPolyData* coarse, vtkPolyData* fine, int maximumLevel, bool morphing = false);
}

#endif

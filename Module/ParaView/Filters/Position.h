// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   positions of points, to identify points of different meshes
 *
 * Pieces of different processes share no point ids.
 *
 * Private to the module.
 */
#ifndef Position_h
#define Position_h

#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relevo
{
/// The coordinates, a key for std::map and std::set; 0 equals -0.
using Position = std::array<double, 3>;

/// Return whether a mesh has a point that a cell refers to.
inline bool HasPoint(vtkPolyData* mesh, vtkIdType point)
{
  return point >= 0 && point < mesh->GetNumberOfPoints();
}

/// Get the position of a point. Return false if there is no point, or if its coordinates are not
/// finite.
inline bool GetPosition(vtkPolyData* mesh, vtkIdType point, Position& position)
{
  if (!HasPoint(mesh, point))
  {
    return false;
  }
  mesh->GetPoint(point, position.data());
  return std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); });
}
}

#endif

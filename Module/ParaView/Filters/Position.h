// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where points lie, to find in one mesh what lies at a place in another
 *
 * Pieces of processes have no ids of points in common.
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
/// Coordinates, a key for std::map and std::set; 0 equals -0.
using Position = std::array<double, 3>;

/// Whether a mesh has a point that a cell refers to.
inline bool HasPoint(vtkPolyData* mesh, vtkIdType point)
{
  return point >= 0 && point < mesh->GetNumberOfPoints();
}

/// Where a point lies: false if there is none, or it has a coordinate that is not finite.
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

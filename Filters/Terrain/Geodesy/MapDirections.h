// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MapDirections
 * @brief   where east and north point in terrain coordinates, place by place
 *
 * Private to the module's own sources.
 */
#ifndef MapDirections_h
#define MapDirections_h

#include "vtkType.h" // for vtkIdType

#include <array>
#include <vector>

namespace relevo
{
/// Terrain coordinates x and y.
using MapPlace = std::array<double, 2>;

/// The steps in x and y that one metre over the earth to the east, and to the north, makes. NaN
/// where there is no such place.
struct MapAxes
{
  MapPlace East;
  MapPlace North;
};

/**
 * The derivative of the way from longitude and latitude to terrain coordinates.
 */
class MapDirections
{
public:
  virtual ~MapDirections() = default;

  /// For every place; safe to call from several threads.
  virtual void Evaluate(const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const = 0;
};
}

#endif

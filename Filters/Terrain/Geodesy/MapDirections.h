// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MapDirections
 * @brief   east and north directions in terrain coordinates
 *
 * Private to the module.
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

/// The change of x and y per metre on the earth to the east and to the north; NaN at positions
/// outside of the map.
struct MapAxes
{
  MapPlace East;
  MapPlace North;
};

/**
 * The derivative of the transform from longitude and latitude to terrain coordinates.
 */
class MapDirections
{
public:
  virtual ~MapDirections() = default;

  /// Evaluates all positions. Can be called from several threads.
  virtual void Evaluate(const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const = 0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TangentPlane
 * @brief   the plane that touches an ellipsoid, as a map of the land around
 *
 * Private to the module's own sources.
 */
#ifndef TangentPlane_h
#define TangentPlane_h

#include <GeographicLib/LocalCartesian.hpp>

#include <array>

namespace relevo
{
struct Georeference;

/**
 * GeographicLib::LocalCartesian at a place and height 0: x east, y north. Longitudes and latitudes
 * are in degrees; latitudes beyond the poles count as the poles, for rasters of points reach half a
 * texel beyond them.
 *
 * Near and beyond the horizon, about 84 degrees from the place, the plane no longer is a map.
 */
class TangentPlane
{
public:
  /// On the ellipsoid of a geographic system; the place in the system's coordinates.
  TangentPlane(const Georeference& system, const std::array<double, 2>& place);

  /// False beyond the horizon.
  bool FromEllipsoid(double longitude, double latitude, std::array<double, 2>& place) const;

  /**
   * The point of the ellipsoid below a place of the plane, and by rows the rotation from east,
   * north, up there to those of the plane. False beyond the horizon.
   */
  bool ToEllipsoid(const std::array<double, 2>& place, double& longitude, double& latitude,
    std::array<double, 9>& rotation) const;

private:
  GeographicLib::LocalCartesian Frame;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TangentPlane
 * @brief   tangent plane of an ellipsoid as a map projection
 *
 * Private to the module.
 */
#ifndef TangentPlane_h
#define TangentPlane_h

#include <GeographicLib/LocalCartesian.hpp>

#include <array>

namespace relevo
{
struct Georeference;

/**
 * Wraps GeographicLib::LocalCartesian at height 0: x east, y north. Longitude and latitude are in
 * degrees. Latitudes are clamped to the poles, because a raster with texels at the poles extends
 * half a texel beyond them.
 *
 * The projection is not invertible near and beyond the horizon, about 84 degrees from the origin.
 */
class TangentPlane
{
public:
  /// Requires a geographic system. `place` is the origin in its coordinates.
  TangentPlane(const Georeference& system, const std::array<double, 2>& place);

  /// Returns false beyond the horizon.
  bool FromEllipsoid(double longitude, double latitude, std::array<double, 2>& place) const;

  /**
   * Computes the point of the ellipsoid below a position of the plane, and the row-major rotation
   * from east, north, up at that point to the axes of the plane. Returns false beyond the horizon.
   */
  bool ToEllipsoid(const std::array<double, 2>& place, double& longitude, double& latitude,
    std::array<double, 9>& rotation) const;

private:
  GeographicLib::LocalCartesian Frame;
};
}

#endif

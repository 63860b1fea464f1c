// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TangentDirections
 * @brief   east and north in the local tangent frame of a terrain in longitude and latitude
 *
 * Private to the module's own sources.
 */
#ifndef TangentDirections_h
#define TangentDirections_h

#include "Geodesy/MapDirections.h"

#include <memory>
#include <string>

namespace relevo
{
class TangentPlane;
struct Georeference;

/**
 * The rotation of the tangent plane at the place on the ellipsoid. A vector that is
 * level there leans out of the tangent plane; what counts is its part in the plane, for z counts
 * from the ellipsoid.
 */
class TangentDirections : public MapDirections
{
public:
  /// For a geographic system; the origin in its coordinates.
  TangentDirections(const Georeference& system, const MapPlace& origin);
  ~TangentDirections() override;

  void Evaluate(const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const override;

private:
  std::unique_ptr<TangentPlane> Plane;
};
}

#endif

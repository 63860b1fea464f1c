// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TangentDirections
 * @brief   east and north directions in the tangent plane of a geographic terrain
 *
 * Private to the module.
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
 * Evaluates the rotation from the horizon at a position to the tangent plane. The component out of
 * the tangent plane is dropped, because z is relative to the ellipsoid.
 */
class TangentDirections : public MapDirections
{
public:
  /// Requires a geographic system. The origin is in its coordinates.
  TangentDirections(const Georeference& system, const MapPlace& origin);
  ~TangentDirections() override;

  void Evaluate(const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const override;

private:
  std::unique_ptr<TangentPlane> Plane;
};
}

#endif

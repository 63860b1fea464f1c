// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GridDirections
 * @brief   east and north on the grid of a projected coordinate system
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
 */
#ifndef GridDirections_h
#define GridDirections_h

#include "Geodesy/Georeference.h"
#include "Geodesy/MapDirections.h"

#include <memory>
#include <string>

namespace relevo
{
/**
 * By central differences of the system's own projection, over some metres along the parallel and
 * the meridian of a place: the grid's convergence, and its scales in both directions.
 */
class GridDirections : public MapDirections
{
public:
  /// `system` describes the one that is defined.
  GridDirections(const std::string& definition, const Georeference& system, const MapPlace& origin);
  ~GridDirections() override;

  /// Whether there is a way between the system and its own longitude and latitude.
  bool IsValid() const;

  void Evaluate(const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const override;

private:
  struct Projection;

  void EvaluateSome(Projection& projection, const MapPlace* places, MapAxes* axes, int count) const;

  std::string Definition;
  Georeference System;
  MapPlace Origin;
};
}

#endif

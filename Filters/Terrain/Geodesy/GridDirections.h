// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GridDirections
 * @brief   east and north directions in a projected coordinate system
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
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
 * Computes central differences of the projection, over some metres along parallel and meridian.
 * They include the grid convergence and the scales in both directions.
 */
class GridDirections : public MapDirections
{
public:
  /// `system` is the parsed `definition`.
  GridDirections(const std::string& definition, const Georeference& system, const MapPlace& origin);
  ~GridDirections() override;

  /// Whether the system can be transformed to longitude and latitude.
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

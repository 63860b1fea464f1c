// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MapFrame
 * @brief   conversion between raster coordinates and a flat map in metres
 *
 * x is east and y is north, with the origin at the centre of the raster. Projected and local
 * coordinates are only shifted and converted to metres. Longitude and latitude are scaled by the
 * lengths of a degree of longitude and of latitude at the centre, on the ellipsoid; this is an
 * equidistant cylindrical projection, and covers the whole earth. Without a georeference, one
 * sample is one unit.
 *
 * Private to the modules for terrains.
 */
#ifndef MapFrame_h
#define MapFrame_h

#include "Geodesy/Georeference.h"
#include "Geodesy/TerrainPlacement.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT MapFrame
{
public:
  explicit MapFrame(const Georeference& location);

  std::array<double, 2> ToMap(const std::array<double, 2>& coordinates) const;
  std::array<double, 2> ToCoordinates(const std::array<double, 2>& map) const;

  /// The position of a raster of this size, in samples.
  TerrainPlacement GetPlacement(int columns, int rows, double heightScale) const;

private:
  Georeference Location;
  std::array<double, 2> Center;
  std::array<double, 2> Lengths; // metres per unit of the coordinates
};
}

#endif

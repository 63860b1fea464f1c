// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainFrame
 * @brief   between a raster's coordinates and metres about its centre
 *
 * Private to the module's own sources.
 */
#ifndef TerrainFrame_h
#define TerrainFrame_h

#include "Geodesy/Georeference.h"

#include <array>
#include <memory>

namespace relevo
{
/**
 * Terrain coordinates: x east, y north, origin at the raster's centre.
 *
 * Longitude and latitude: GeographicLib::LocalCartesian at the centre and height 0, on the
 * coordinate system's ellipsoid. Lengths: differences from the centre, in metres. No georeference:
 * differences in texels.
 */
class TerrainFrame
{
public:
  explicit TerrainFrame(const Georeference& location);
  ~TerrainFrame();

  /// The centre in the raster's coordinates.
  const std::array<double, 2>& GetCenter() const { return this->Center; }

  /**
   * The place of (u, v). False where the tangent plane no longer is a map of the ellipsoid: near
   * and beyond the horizon, about 84 degrees from the centre.
   */
  bool Place(double u, double v, std::array<double, 2>& place) const;

  /// Whether the whole footprint has places.
  bool IsWithinHorizon() const;

  //@{
  /**
   * From the raster's coordinates to the place there and back. False beyond the horizon.
   */
  bool ToPlace(const std::array<double, 2>& coordinates, std::array<double, 2>& place) const;
  bool ToCoordinates(const std::array<double, 2>& place, std::array<double, 2>& coordinates) const;
  //@}

  /// Whether the raster's coordinates are longitude and latitude.
  bool IsGeographic() const { return this->Frame != nullptr; }

private:
  struct Tangent;

  Georeference Location;
  std::array<double, 2> Center;
  std::unique_ptr<Tangent> Frame; // for longitude and latitude only
};
}

#endif

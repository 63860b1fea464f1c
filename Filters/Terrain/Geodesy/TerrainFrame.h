// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::TerrainFrame
 * @brief   between a raster's coordinates and metres about its centre
 */
#ifndef TerrainFrame_h
#define TerrainFrame_h

#include "Geodesy/Georeference.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <memory>
#include <string>

namespace relevo
{
class TangentPlane;

/**
 * Terrain coordinates: x east, y north, origin at the raster's centre.
 *
 * Longitude and latitude: the tangent plane at the centre. Lengths: differences from the centre, in
 * metres. No georeference: differences in texels.
 */
class RELEVOFILTERSTERRAIN_EXPORT TerrainFrame
{
public:
  explicit TerrainFrame(const Georeference& location);
  ~TerrainFrame();

  /// The centre in the raster's coordinates.
  const std::array<double, 2>& GetCenter() const { return this->Center; }

  /// The place of (u, v). False beyond the horizon.
  bool Place(double u, double v, std::array<double, 2>& place) const;

  /// The (u, v) of a place. False beyond the horizon.
  bool ToParameters(const std::array<double, 2>& place, std::array<double, 2>& uv) const;

  /// Whether the whole footprint has places.
  bool IsWithinHorizon() const;

  /// From the middle of a side to that of the side across, along u and along v, as parallels and
  /// meridians go.
  std::array<double, 2> GetLengths() const;

  /// Whether the footprint has an extent, and floats have room for its places.
  bool FitsMesh() const;

  //@{
  /**
   * From the raster's coordinates to the place there and back. False beyond the horizon.
   */
  bool ToPlace(const std::array<double, 2>& coordinates, std::array<double, 2>& place) const;
  bool ToCoordinates(const std::array<double, 2>& place, std::array<double, 2>& coordinates) const;
  //@}

  /// Whether the raster's coordinates are longitude and latitude.
  bool IsGeographic() const { return this->Plane != nullptr; }

private:
  Georeference Location;
  std::array<double, 2> Center;
  std::unique_ptr<TangentPlane> Plane; // for longitude and latitude only
};

/// Whether coordinates without a system may be longitudes and latitudes.
RELEVOFILTERSTERRAIN_EXPORT bool LooksGeographic(const Georeference& location, const int texels[2]);

/// Why a raster there can be no terrain, to follow its name; or "".
RELEVOFILTERSTERRAIN_EXPORT std::string FindLocationError(const Georeference& location);
}

#endif

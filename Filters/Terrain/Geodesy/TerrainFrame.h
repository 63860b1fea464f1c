// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::TerrainFrame
 * @brief   conversion between raster coordinates and terrain coordinates
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
 * Terrain coordinates are x east and y north, with the origin at the centre of the raster.
 *
 * For longitude and latitude, they are in the tangent plane at the centre. For planar systems, they
 * are differences from the centre in metres. Without georeference, they are differences in texels.
 */
class RELEVOFILTERSTERRAIN_EXPORT TerrainFrame
{
public:
  explicit TerrainFrame(const Georeference& location);
  ~TerrainFrame();

  /// Returns the centre in raster coordinates.
  const std::array<double, 2>& GetCenter() const { return this->Center; }

  /// Converts (u, v) to terrain coordinates. Returns false beyond the horizon.
  bool Place(double u, double v, std::array<double, 2>& place) const;

  /// Converts terrain coordinates to (u, v). Returns false beyond the horizon.
  bool ToParameters(const std::array<double, 2>& place, std::array<double, 2>& uv) const;

  /// Whether the whole footprint is within the horizon.
  bool IsWithinHorizon() const;

  /// Returns the distances between the midpoints of opposite sides, measured along u and along v on
  /// parallels and meridians.
  std::array<double, 2> GetLengths() const;

  /// Whether the footprint has an area and fits the range of float.
  bool FitsMesh() const;

  //@{
  /**
   * Convert raster coordinates to terrain coordinates and back. Return false beyond the horizon.
   */
  bool ToPlace(const std::array<double, 2>& coordinates, std::array<double, 2>& place) const;
  bool ToCoordinates(const std::array<double, 2>& place, std::array<double, 2>& coordinates) const;
  //@}

  /// Whether the raster coordinates are longitude and latitude.
  bool IsGeographic() const { return this->Plane != nullptr; }

private:
  Georeference Location;
  std::array<double, 2> Center;
  std::unique_ptr<TangentPlane> Plane; // for longitude and latitude only
};

/// Whether coordinates without a coordinate system are possibly longitude and latitude.
RELEVOFILTERSTERRAIN_EXPORT bool LooksGeographic(const Georeference& location, const int texels[2]);

/// Returns a reason to doubt the lengths of a raster with this location, as a continuation of its
/// name, or "": its coordinates look like degrees, or its projection scales lengths.
RELEVOFILTERSTERRAIN_EXPORT std::string FindLocationWarning(
  const Georeference& location, const int texels[2]);

/// Returns why a coordinate system is not supported, as a continuation of the raster's name, or "".
RELEVOFILTERSTERRAIN_EXPORT std::string FindSystemError(const Georeference& location);

/// Returns why a raster with this location has no terrain coordinates, as a continuation of its
/// name, or "".
RELEVOFILTERSTERRAIN_EXPORT std::string FindLocationError(const Georeference& location);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GeocentricFrame
 * @brief   conversion between raster coordinates and earth-centred coordinates in metres
 *
 * The ellipsoid is that of the coordinate system. z points to the north pole, and x to longitude 0.
 * Projected coordinates are converted to longitude and latitude with GDAL.
 *
 * Private to the modules for terrains.
 */
#ifndef GeocentricFrame_h
#define GeocentricFrame_h

#include "Geodesy/Georeference.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <memory>
#include <string>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT GeocentricFrame
{
public:
  explicit GeocentricFrame(const Georeference& location);
  ~GeocentricFrame();
  GeocentricFrame(const GeocentricFrame&) = delete;
  void operator=(const GeocentricFrame&) = delete;

  /// Why there is no such frame, as a continuation of the raster's name, or "".
  const std::string& GetError() const { return this->Error; }

  double GetSemiMajorAxis() const { return this->Location.SemiMajorAxis; }
  double GetFlattening() const { return this->Location.Flattening; }
  bool IsGeographic() const { return this->Location.System == Georeference::Kind::Geographic; }

  /// Convert raster coordinates to longitude and latitude in degrees, in place. They are NaN
  /// outside of the projection. Thread-safe.
  void ToAngles(std::size_t number, double* x, double* y) const;

  /// A point of the ellipsoid and the direction up.
  struct Place
  {
    std::array<double, 3> Position;
    std::array<double, 3> Up;
  };
  /// Latitudes beyond a pole are on the other side of it.
  Place GetPlace(double longitude, double latitude) const;

  /// The radii of curvature along the parallel and along the meridian.
  std::array<double, 2> GetRadii(double latitude) const;

  //@{
  /// Convert longitude and latitude in degrees and the height above the ellipsoid in metres.
  std::array<double, 3> ToWorld(const std::array<double, 3>& geographic) const;
  std::array<double, 3> ToGeographic(const std::array<double, 3>& world) const;
  //@}

private:
  struct Projections;

  Georeference Location;
  std::string Error;
  std::unique_ptr<Projections> Pool;
};
}

#endif

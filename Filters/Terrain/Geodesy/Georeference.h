// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::Georeference
 * @brief   where a raster lies on the earth
 *
 * Private to the modules' own sources.
 */
#ifndef Georeference_h
#define Georeference_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <string>

namespace relevo
{
/**
 * The footprint of a raster, pixel edge to pixel edge, in its own coordinate system, and what
 * those coordinates mean.
 */
struct RELEVOFILTERSTERRAIN_EXPORT Georeference
{
  enum class Kind
  {
    None,        ///< columns and rows only
    Planar,      ///< lengths: projected, local, or a transform without a coordinate system
    Geographic,  ///< angles: longitude and latitude
    Unsupported, ///< e.g. geocentric
    NoEllipsoid  ///< angles or lengths on an ellipsoid that is none
  };

  Kind System = Kind::None;

  /// The coordinate system, empty when unknown.
  std::string WKT;

  /// Metres (Planar) or degrees (Geographic) in one unit of the coordinates.
  double Unit = 1.0;

  //@{
  /// The ellipsoid, WGS 84 unless the coordinate system says otherwise.
  double SemiMajorAxis = 6378137.0;
  double Flattening = 1.0 / 298.257223563;
  //@}

  //@{
  /// Coordinates at (u, v): Corner + u AlongU + v AlongV.
  std::array<double, 2> Corner = { 0.0, 0.0 };
  std::array<double, 2> AlongU = { 1.0, 0.0 };
  std::array<double, 2> AlongV = { 0.0, 1.0 };
  //@}

  //@{
  /// Whether u runs against the file's columns, v against its rows.
  bool FlipColumns = false;
  bool FlipRows = true;
  //@}

  /// For a raster without georeference: one texel is one unit, v = 0 is the last row.
  void SetSize(int width, int height);

  /**
   * From the affine transform of column and row (GDAL's order of coefficients). u is directed
   * east rather than west, and v so that (u, v) is right-handed: north for axis-aligned rasters.
   * Returns false for a singular transform.
   */
  bool SetAffineTransform(const double transform[6], int width, int height);

  std::array<double, 2> Coordinates(double u, double v) const;

  /// The (u, v) that has these coordinates.
  std::array<double, 2> Parameters(const std::array<double, 2>& coordinates) const;
};
}

#endif

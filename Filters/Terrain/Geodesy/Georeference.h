// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::Georeference
 * @brief   location of a raster on the earth
 */
#ifndef Georeference_h
#define Georeference_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <string>

namespace relevo
{
/**
 * The footprint of a raster, from pixel edge to pixel edge, in its coordinate system, with the type
 * of the coordinates.
 */
struct RELEVOFILTERSTERRAIN_EXPORT Georeference
{
  enum class Kind
  {
    None,        ///< no georeference: columns and rows
    Planar,      ///< lengths: projected, local, or a transform without coordinate system
    Geographic,  ///< angles: longitude and latitude
    Unsupported, ///< e.g. geocentric
    NoEllipsoid  ///< angles or lengths on an invalid ellipsoid
  };

  Kind System = Kind::None;

  /// The coordinate system; empty if unknown.
  std::string WKT;

  /// Metres (Planar) or degrees (Geographic) per unit of the coordinates.
  double Unit = 1.0;

  //@{
  /// The ellipsoid; WGS 84 if the coordinate system specifies none.
  double SemiMajorAxis = 6378137.0;
  double Flattening = 1.0 / 298.257223563;
  //@}

  //@{
  /// The coordinates at (u, v) are Corner + u * AlongU + v * AlongV.
  std::array<double, 2> Corner = { 0.0, 0.0 };
  std::array<double, 2> AlongU = { 1.0, 0.0 };
  std::array<double, 2> AlongV = { 0.0, 1.0 };
  //@}

  //@{
  /// Whether u and v run opposite to the columns and rows of the file.
  bool FlipColumns = false;
  bool FlipRows = true;
  //@}

  /// Sets a location without georeference: one texel is one unit, v = 0 is the last row.
  void SetSize(int width, int height);

  /**
   * Sets the affine transform from column and row to coordinates, in GDAL's order of coefficients.
   * u is oriented to the east, and v so that (u, v) is right-handed: north for axis-aligned
   * rasters. Returns false if the transform is singular.
   */
  bool SetAffineTransform(const double transform[6], int width, int height);

  std::array<double, 2> Coordinates(double u, double v) const;

  /// Returns (u, v) at the given coordinates.
  std::array<double, 2> Parameters(const std::array<double, 2>& coordinates) const;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainGround
 * @brief   heights and coordinates of a terrain at its x and y
 *
 * Points are in world coordinates: x east and y north from the centre of the raster, z up.
 */
#ifndef TerrainGround_h
#define TerrainGround_h

#include <array>
#include <string>

class TerrainGround
{
public:
  virtual ~TerrainGround() = default;

  /// Gets the raster's height, in its unit. Returns false outside the terrain and for missing data.
  virtual bool GetHeight(double x, double y, double& height) = 0;

  /// The z of a height of the raster.
  virtual double GetZ(double height) = 0;

  /// Gets a z that the ground nearby does not exceed, as drawn. `spacing` is the distance to the
  /// next point that is asked for, or 0. Returns false outside the terrain and in holes.
  virtual bool GetHighestGround(double x, double y, double spacing, double& z) = 0;

  /// Moves x and y to the nearest point of the terrain.
  virtual void MoveOnto(double place[2]) = 0;

  /// The smallest and largest x and y.
  virtual std::array<double, 4> GetExtent() = 0;

  virtual bool HasCoordinateSystem() = 0;
  /// Whether the raster's own coordinates are longitude and latitude.
  virtual bool IsGeographic() = 0;
  /// Metres per unit of the raster's heights.
  virtual double GetVerticalUnit() = 0;

  //@{
  /// Convert x and y from and to the raster's own coordinates, and from and to longitude and
  /// latitude in degrees. Return false if a point cannot be converted.
  virtual bool ToRaster(const double place[2], double coordinates[2]) = 0;
  virtual bool FromRaster(const double coordinates[2], double place[2]) = 0;
  virtual bool FromDegrees(const double degrees[2], double place[2]) = 0;
  //@}
  /// Converts x and y to degrees if these are not the raster's own coordinates.
  virtual bool ToDegrees(const double place[2], double degrees[2]) = 0;
};

#endif

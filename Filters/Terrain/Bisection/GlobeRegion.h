// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeRegion
 * @brief   the heights of a part of a raster on a globe, and the errors of flat triangles on it
 *
 * A raster that covers all longitudes is closed: the first column follows the last. If it has a
 * pole, all columns of the row there have the same height.
 *
 * Private to the module.
 */
#ifndef GlobeRegion_h
#define GlobeRegion_h

#include "Bisection/LatticeDecimation.h"
#include "Geodesy/TerrainPlacement.h"

#include <array>
#include <vector>

namespace relevo
{
class AdaptiveTerrain;

class GlobeRegion
{
public:
  /// The terrain has a globe. The first vertex of the window of a level is at this column and row.
  GlobeRegion(const AdaptiveTerrain& terrain, double exaggeration, int level, int column, int row);

  /**
   * Close the heights of a window of width x height vertices, which grows if the raster is closed.
   * columns[1] and rows[1] are the last ones, in samples.
   */
  void Close(
    std::vector<float>& heights, int& width, int& height, double columns[2], double rows[2]);

  /**
   * The vertical distance between the terrain and a flat triangle whose vertices lie on it, at
   * most, in the unit of the heights before the exaggeration: a flat triangle is below the
   * ellipsoid. Slopes are up to 45 degrees.
   */
  double GetShapeError(const LatticeDecimation::Bounds& bounds) const;
  /// The same, for all cells of the lattice.
  double GetShapeErrorOfCell() const;

private:
  /// Whether the raster has the pole of its first (0) or last (1) row.
  bool HasPole(int end) const;
  double ToHeight(double distance) const;
  void SetPole(std::vector<float>& heights, int width, int row, float height) const;

  const AdaptiveTerrain& Terrain;
  TerrainPlacement Placement;
  double Exaggeration;
  double Size; // of a cell, in samples
  double First[2];
  double Growth = 1.0; // of lengths on the ellipsoid, by the heights above it
};
}

#endif

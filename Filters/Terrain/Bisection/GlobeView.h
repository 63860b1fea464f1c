// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeView
 * @brief   distances, visibility and errors of a terrain in the geocentric frame
 *
 * All bounds of a box are at most those of a larger one, or at least for distances, so that errors
 * stay saturated; see BlockErrors. Private to the modules for terrains.
 */
#ifndef GlobeView_h
#define GlobeView_h

#include "Bisection/TerrainBox.h"
#include "Geodesy/TerrainPlacement.h"

#include <array>

namespace relevo
{
class GlobeView
{
public:
  /// The placement has a globe.
  GlobeView(const TerrainPlacement& placement, const std::array<double, 3>& eye);
  GlobeView(const GlobeView&) = delete;
  void operator=(const GlobeView&) = delete;

  /// The distance of the eye from the points of a box, at least.
  double GetDistance(const TerrainBox& box) const;

  /**
   * The vertical distance between the terrain and faces whose vertices lie on it, at most, in the
   * unit of the heights: flat triangles are below the ellipsoid. It is saturated. Where the raster
   * is closed, BlockErrors are not bounds, and it includes the range of all heights of the box, or
   * the errors of the poles.
   */
  double GetShapeError(int level, bool isSquare, const TerrainBox& box) const;

  /// Whether a part of a box may be in front of all planes and of the horizon. The ellipsoid has a
  /// horizon for perspective views only.
  bool IsVisible(const TerrainBox& box, const std::array<std::array<double, 4>, 6>* planes,
    bool hasHorizon) const;

private:
  TerrainBox Clamp(const TerrainBox& box) const;
  bool IsBehindHorizon(const std::array<std::array<double, 3>, 8>& corners, double margin) const;

  TerrainPlacement Placement;
  const GlobeShape& Shape; // of the placement
  std::array<double, 3> Eye;
  std::array<double, 3> Ground; // the point of the ellipsoid below the eye
  double EyeHeight;
  double LargestRadius; // of curvature
  double SmallestRadius;
};
}

#endif

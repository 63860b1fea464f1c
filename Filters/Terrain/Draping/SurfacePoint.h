// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SurfacePoint
 * @brief   a point of a terrain's surface, as a weighted mean of up to three vertices
 *
 * Points of the same triangle are means of its vertices, also in world coordinates.
 *
 * Private to the modules for terrains.
 */
#ifndef SurfacePoint_h
#define SurfacePoint_h

#include "Draping/MapSegment.h"

#include <array>
#include <cmath>

namespace relevo
{
struct SurfaceVertex
{
  MapPosition Position = { { 0.0, 0.0 } };
  double Height = 0.0;                                 // in the unit of the raster
  std::array<double, 3> World = { { 0.0, 0.0, 0.0 } }; // the position in world coordinates
  std::array<double, 3> Up = { { 0.0, 0.0, 1.0 } };
};

struct SurfacePoint
{
  std::array<SurfaceVertex, 3> Vertices;
  std::array<double, 3> Weights = { { 1.0, 0.0, 0.0 } };

  double GetHeight() const
  {
    return this->Weights[0] * this->Vertices[0].Height +
      this->Weights[1] * this->Vertices[1].Height + this->Weights[2] * this->Vertices[2].Height;
  }

  /// The point in world coordinates, lifted by a distance.
  std::array<double, 3> GetWorld(double lift) const
  {
    std::array<double, 3> world = { { 0.0, 0.0, 0.0 } };
    std::array<double, 3> up = { { 0.0, 0.0, 0.0 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 3; ++i)
      {
        world[axis] += this->Weights[i] * this->Vertices[i].World[axis];
        up[axis] += this->Weights[i] * this->Vertices[i].Up[axis];
      }
    }
    const double length = std::hypot(up[0], up[1], up[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      world[axis] += lift * up[axis] / length;
    }
    return world;
  }
};

using SurfaceTriangle = std::array<SurfaceVertex, 3>;

/// Return twice the signed area of a triangle on the map; positive if it turns from columns to
/// rows.
inline double GetTwiceArea(const MapPosition& a, const MapPosition& b, const MapPosition& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Return the weights of the corners of a triangle at a position.
inline std::array<double, 3> GetTriangleWeights(
  const std::array<MapPosition, 3>& corners, const MapPosition& position)
{
  const auto& [a, b, c] = corners;
  const double area = GetTwiceArea(a, b, c);
  const double second = GetTwiceArea(a, position, c) / area;
  const double third = GetTwiceArea(a, b, position) / area;
  return { { 1.0 - second - third, second, third } };
}

/// Return the point of a triangle's plane at a position.
inline SurfacePoint GetSurfacePoint(const SurfaceTriangle& triangle, const MapPosition& position)
{
  return { triangle,
    GetTriangleWeights(
      { { triangle[0].Position, triangle[1].Position, triangle[2].Position } }, position) };
}
}

#endif

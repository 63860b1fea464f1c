// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SurfacePoint
 * @brief   a point of a terrain's surface, as a weighted mean of up to three vertices
 *
 * Vertices have the column and row of the raster (whole numbers at the centres of samples) and a
 * height in its unit. Points of the same triangle are means of its vertices in world coordinates.
 *
 * Private to the modules for terrains.
 */
#ifndef SurfacePoint_h
#define SurfacePoint_h

#include <array>

namespace relevo
{
struct SurfaceVertex
{
  double Column = 0.0;
  double Row = 0.0;
  double Height = 0.0;
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
};

using SurfaceTriangle = std::array<SurfaceVertex, 3>;

/// Return twice the signed area of a triangle on the map; positive if it turns from columns to
/// rows.
inline double GetTwiceArea(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c)
{
  return (b.Column - a.Column) * (c.Row - a.Row) - (b.Row - a.Row) * (c.Column - a.Column);
}

/// Return the point of a triangle's plane at a column and row.
inline SurfacePoint GetSurfacePoint(const SurfaceTriangle& triangle, double column, double row)
{
  const SurfaceVertex position = { column, row, 0.0 };
  const auto& [a, b, c] = triangle;
  const double area = GetTwiceArea(a, b, c);
  SurfacePoint point;
  point.Vertices = triangle;
  point.Weights[1] = GetTwiceArea(a, position, c) / area;
  point.Weights[2] = GetTwiceArea(a, b, position) / area;
  point.Weights[0] = 1.0 - point.Weights[1] - point.Weights[2];
  return point;
}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DistanceBound
 * @brief   an upper bound of the distance of all points of a triangle to a surface
 *
 * The distance to one triangle is a convex function, so on a triangle it is largest at a corner.
 * The bound is the smallest such maximum over the triangles of the surface that are nearest to the
 * corners. If it is above the tolerance, the triangle is bisected. Bounds therefore hold for all
 * points, not only for samples.
 */
#ifndef DistanceBound_h
#define DistanceBound_h

#include "Distance/TriangleTree.h"

namespace relevo
{
class DistanceBound
{
public:
  /// A point and a triangle of the surface near it; -1 if none is within the tolerance.
  struct Corner
  {
    dvec3 Point;
    int Nearest;
  };

  DistanceBound(const TriangleTree& surface, double tolerance)
    : Surface(surface)
    , Tolerance2(tolerance * tolerance)
  {
  }

  /// Find a triangle of the surface within the tolerance. `guess` is a triangle or -1.
  Corner FindCorner(const dvec3& point, int guess = -1) const;

  /// The square of the bound. It is infinite if it may be above the tolerance.
  double GetBound2(const Corner& a, const Corner& b, const Corner& c) const;

private:
  double GetFarthest2(int triangle, const Corner& a, const Corner& b, const Corner& c) const;

  const TriangleTree& Surface;
  double Tolerance2;
};
}

#endif

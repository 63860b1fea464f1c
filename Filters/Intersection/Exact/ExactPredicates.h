// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   exact orientation predicates for double coordinates
 *
 * A determinant in double is used if it exceeds the error bound of J. R. Shewchuk ("Adaptive
 * Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997), extended for
 * underflow. Otherwise it is computed with integers of arbitrary length. Coordinates must be
 * finite.
 */
#ifndef ExactPredicates_h
#define ExactPredicates_h

#include "RelevoFiltersIntersectionModule.h" // for export macro

namespace relevo
{
/**
 * Returns 1 if d is on the side of the plane of a, b, c that the normal (b - a) x (c - a) points
 * to, -1 if it is on the other side, and 0 if it is in the plane.
 */
RELEVOFILTERSINTERSECTION_EXPORT int Orient3D(
  const double a[3], const double b[3], const double c[3], const double d[3]);

/**
 * Returns 1 if a, b, c turn left, seen from the direction that the axis (0, 1, 2) points to, -1 if
 * they turn right, and 0 if they are collinear in this view.
 */
RELEVOFILTERSINTERSECTION_EXPORT int Orient2D(
  const double a[3], const double b[3], const double c[3], int axis);

/**
 * Returns an axis along which the projection of a triangle has an area, or -1 if the triangle has
 * none.
 */
RELEVOFILTERSINTERSECTION_EXPORT int FindAxis(
  const double a[3], const double b[3], const double c[3]);
}

#endif

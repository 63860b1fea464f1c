// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   on which side points lie, decided exactly for the doubles given
 *
 * A determinant in double decides where it is beyond the bound of its rounding errors of J. R.
 * Shewchuk ("Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
 * 1997), widened by what underflow can do; else integers of any length do. Coordinates are finite.
 */
#ifndef ExactPredicates_h
#define ExactPredicates_h

#include "RelevoFiltersIntersectionModule.h" // for export macro

namespace relevo
{
/**
 * 1 if d is on the side of the plane of a, b, c that the normal (b - a) x (c - a) points to, -1 if
 * on the other, 0 if in the plane.
 */
RELEVOFILTERSINTERSECTION_EXPORT int Orient3D(
  const double a[3], const double b[3], const double c[3], const double d[3]);

/**
 * 1 if a, b, c turn left, seen from where the axis (0, 1, 2) points to, -1 if right, 0 if seen in
 * a line.
 */
RELEVOFILTERSINTERSECTION_EXPORT int Orient2D(
  const double a[3], const double b[3], const double c[3], int axis);

/**
 * An axis along which a triangle is seen with an area; -1 if it has none.
 */
RELEVOFILTERSINTERSECTION_EXPORT int FindAxis(
  const double a[3], const double b[3], const double c[3]);
}

#endif

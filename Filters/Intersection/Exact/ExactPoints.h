// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersections of lines with planes and lines, as exact quotients that are rounded once
 */
#ifndef ExactPoints_h
#define ExactPoints_h

namespace relevo
{
/**
 * Intersects the line p q with the plane of a, b, c. They must not be parallel.
 */
void CrossPlane(const double p[3], const double q[3], const double a[3], const double b[3],
  const double c[3], double x[3]);

/**
 * Intersects the line p q with the line a b. They must be coplanar and not parallel.
 */
void CrossLine(
  const double p[3], const double q[3], const double a[3], const double b[3], double x[3]);
}

#endif

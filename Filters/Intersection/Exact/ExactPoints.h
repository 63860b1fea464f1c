// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   points where lines meet planes and lines, as exact quotients that are rounded once
 */
#ifndef ExactPoints_h
#define ExactPoints_h

namespace relevo
{
/**
 * Where the line p q meets the plane of a, b, c, to which it is not parallel.
 */
void CrossPlane(const double p[3], const double q[3], const double a[3], const double b[3],
  const double c[3], double x[3]);

/**
 * Where the line p q meets the line a b, which are in one plane and not parallel.
 */
void CrossLine(
  const double p[3], const double q[3], const double a[3], const double b[3], double x[3]);
}

#endif

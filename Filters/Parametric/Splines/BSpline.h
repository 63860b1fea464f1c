// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   B-splines as Bézier curves, by knot insertion
 *
 * Private to the module's own sources.
 */
#ifndef BSpline_h
#define BSpline_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
/**
 * The Bézier control points of each span (FindSpans()), degree + 1 for each, one span's after the
 * other's: Boehm's knot insertion up to multiplicity degree at both ends of the span (L. Piegl,
 * W. Tiller, "The NURBS Book", algorithm A5.1). Where two spans join their common point is the
 * same to the bit. Points may be homogeneous.
 */
std::vector<dvec4> DecomposeIntoBezier(
  int degree, const std::vector<double>& knots, const std::vector<dvec4>& points);
}

#endif

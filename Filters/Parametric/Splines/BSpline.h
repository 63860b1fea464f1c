// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   decomposition of B-splines into Bézier curves
 *
 * Private to the module.
 */
#ifndef BSpline_h
#define BSpline_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
/**
 * Returns degree + 1 Bézier control points for each span of FindSpans(). Boehm's knot insertion
 * raises the knots at both ends of the span to multiplicity degree (L. Piegl, W. Tiller, "The NURBS
 * Book", algorithm A5.1). The common point of two joined spans is bitwise identical. Points may be
 * homogeneous.
 */
std::vector<dvec4> DecomposeIntoBezier(
  int degree, const std::vector<double>& knots, const std::vector<dvec4>& points);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   deviation of rational Bézier triangles from linear interpolation
 *
 * Let S_dd be the second derivative in a direction d of barycentric coordinates. Consider a
 * triangle of parameters with corners x_k and a point x = sum of mu_k x_k. The deviation at x is
 *
 *     |S(x) - sum mu_k S(x_k)| <= 1/2 sum mu_k max |S_dd|,  d = x_k - x,
 *
 * by Taylor's theorem (after Filip, Magedson and Markot 1986). If |S_dd| <= sum F_c d_c^2 for all
 * d, this is a sum of variances of coordinates. A variance is at most a quarter of the squared
 * range of the coordinate over the triangle, so that
 *
 *     |S(x) - sum mu_k S(x_k)| <= 1/8 sum F_c range_c^2.
 *
 * SecondDerivatives bounds |S_de| for two directions.
 *
 * Private to the module.
 */
#ifndef DeviationBounds_h
#define DeviationBounds_h

#include "Mathematics/RefinementMathematics.h"

#include <vector> // for points

namespace relevo
{
class TriangleForm;

/// Returns the F with the smallest sum.
dvec3 ComputeDeviationForm(const TriangleForm& triangle);
}

#endif

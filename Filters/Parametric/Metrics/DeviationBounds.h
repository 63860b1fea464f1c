// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how far rational Bézier triangles are from their linear interpolation
 *
 * With second derivatives S_dd in a direction d, of the triangle's barycentric coordinates, a
 * point x = sum of mu_k x_k of a triangle in the parameters is off by
 *
 *     |S(x) - sum mu_k S(x_k)| <= 1/2 sum mu_k max |S_dd|,  d = x_k - x,
 *
 * (Taylor's theorem; after Filip, Magedson and Markot 1986). A form with |S_dd| <= sum F_c d_c^2
 * for all d makes that a sum of variances of coordinates, and these are at most a quarter of the
 * coordinate's squared range over the triangle:
 *
 *     |S(x) - sum mu_k S(x_k)| <= 1/8 sum F_c range_c^2.
 *
 * SecondDerivatives bounds |S_de| for two directions.
 *
 * Private to the module's own sources.
 */
#ifndef DeviationBounds_h
#define DeviationBounds_h

#include "Mathematics/RefinementMathematics.h"

#include <vector> // for points

namespace relevo
{
class TriangleForm;

/// F, of the form above; of all such F one of least sum.
dvec3 ComputeDeviationForm(const TriangleForm& triangle);
}

#endif

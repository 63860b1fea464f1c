// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   conversion of Lagrange nodes to Bézier coefficients
 */
#ifndef LagrangeToBezier_h
#define LagrangeToBezier_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <cstddef> // for std::ptrdiff_t

namespace relevo
{
/**
 * Replaces the degree + 1 nodes of a Lagrange curve of degree 1 to 8 by Bézier coefficients. Nodes
 * have any number of components and are `stride` values apart. Both ends are not changed. Reversing
 * the nodes reverses the coefficients, to the bit.
 */
RELEVOFILTERSCORE_EXPORT void ConvertLagrangeToBezier(
  int degree, int components, double* values, std::ptrdiff_t stride);

/**
 * Does the same for the (degree + 1) (degree + 2) / 2 nodes of a triangle, see GetTriangleIndex().
 * Its edges are bitwise identical to the results of ConvertLagrangeToBezier().
 */
RELEVOFILTERSCORE_EXPORT void ConvertLagrangeTriangleToBezier(
  int degree, int components, double* values);
}

#endif

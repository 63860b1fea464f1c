// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Bézier coefficients of what interpolates equally spaced nodes
 *
 * Private to the module's own sources.
 */
#ifndef LagrangeToBezier_h
#define LagrangeToBezier_h

#include <cstddef>

namespace relevo
{
/**
 * Replaces the degree + 1 nodes of a Lagrange curve, of any number of components each, by Bézier
 * coefficients. Nodes lie `stride` values apart. Both ends stay as they are, to the bit, and the
 * coefficients have the same bits from whichever end the nodes are given. Degrees 1 to 8.
 */
void ConvertLagrangeToBezier(int degree, int components, double* values, std::ptrdiff_t stride);

/**
 * The same of a triangle's (degree + 1) (degree + 2) / 2 nodes, see GetTriangleIndex(). Its edges
 * have the bits of ConvertLagrangeToBezier().
 */
void ConvertLagrangeTriangleToBezier(int degree, int components, double* values);
}

#endif

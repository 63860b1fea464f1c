// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   knots of a B-spline: whether they can be used, and the spans between them
 *
 * Private to the module's own sources.
 */
#ifndef KnotVector_h
#define KnotVector_h

#include <string>
#include <vector>

namespace relevo
{
/// What is wrong with the knots for so many control points; empty if nothing is.
std::string FindKnotError(const std::vector<double>& knots, int degree, std::size_t points);

/// Each k with knots[k] < knots[k + 1] where the curve is defined: from knots[degree] to the
/// degree-th before the last.
std::vector<int> FindSpans(const std::vector<double>& knots, int degree);
}

#endif

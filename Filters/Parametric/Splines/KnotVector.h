// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   validation of B-spline knots and search for their spans
 *
 * Private to the module.
 */
#ifndef KnotVector_h
#define KnotVector_h

#include <string>
#include <vector>

namespace relevo
{
/// Returns the error of the knots for the given number of control points, or "".
std::string FindKnotError(const std::vector<double>& knots, int degree, std::size_t points);

/// Returns each k with knots[k] < knots[k + 1] in the domain of the curve, which reaches from
/// knots[degree] to knots[knots.size() - 1 - degree].
std::vector<int> FindSpans(const std::vector<double>& knots, int degree);
}

#endif

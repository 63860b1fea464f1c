// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the vertices on the border of a pattern, in integers
 */
#ifndef PatternBorder_h
#define PatternBorder_h

#include "Patterns/CanonicalOrder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace relevo
{
/// The highest number of segments of an edge.
constexpr int MaximumNumberOfSegments = 1 << HighestLevel;

/// The weights of a vertex for (P1, P2, P3), in units that the user chooses.
using PatternWeights = std::array<std::int64_t, 3>;

/// Weights of patterns are multiples of 1 / WeightScale. They and their sums are exact in float.
constexpr std::int64_t WeightScale = std::int64_t(1) << 24;

/**
 * Return the corners, then the points between the segments of edges 1, 2 and 3, in the order of the
 * pattern and in units of 1 / scale. They are the same from both ends of an edge.
 */
std::vector<PatternWeights> MakeBorderVertices(const int segments[3], std::int64_t scale);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the vertices on the border of a pattern, in integers
 *
 * Private to the module's own sources.
 */
#ifndef PatternBorder_h
#define PatternBorder_h

#include "Patterns/CanonicalOrder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace relevo
{
/// The most segments an edge may have.
constexpr int MaximumNumberOfSegments = 1 << HighestLevel;

/// A vertex's weights for (P1, P2, P3), in units that the user chooses.
using PatternWeights = std::array<std::int64_t, 3>;

/// A pattern's weights are multiples of 1 / WeightScale, all exact in float, as are their sums.
constexpr std::int64_t WeightScale = std::int64_t(1) << 24;

/**
 * The corners, then the points between the segments of edges 1, 2 and 3, in the pattern's order and
 * in units of 1 / scale. They are the same from both ends of an edge.
 */
std::vector<PatternWeights> MakeBorderVertices(const int segments[3], std::int64_t scale);
}

#endif

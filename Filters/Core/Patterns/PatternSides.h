// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the sides of a pattern's triangles
 */
#ifndef PatternSides_h
#define PatternSides_h

#include <utility>
#include <vector>

namespace relevo
{
struct RefinementPattern;
/// From one vertex to another.
using PatternSide = std::pair<unsigned int, unsigned int>;

/**
 * Return the sides of all triangles, counter-clockwise around each, sorted.
 */
std::vector<PatternSide> SortedSides(const std::vector<unsigned int>& triangles);

/**
 * Return the segments of edges 1, 2, 3, in order and direction.
 */
std::vector<PatternSide> BorderSides(const int segments[3]);

/**
 * Whether sorted sides contain this one.
 */
bool Contains(const std::vector<PatternSide>& sorted, PatternSide side);

/**
 * Compute the lines of a pattern from its other data.
 */
void MakeLines(RefinementPattern& pattern);
}

#endif

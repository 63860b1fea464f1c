// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the sides of a pattern's triangles
 *
 * Private to the module's own sources.
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
 * The sides of all triangles, counter-clockwise around each, sorted.
 */
std::vector<PatternSide> SortedSides(const std::vector<unsigned int>& triangles);

/**
 * The segments of edges 1, 2, 3, in order and direction.
 */
std::vector<PatternSide> BorderSides(const int segments[3]);

/**
 * Whether sorted sides include this one.
 */
bool Contains(const std::vector<PatternSide>& sorted, PatternSide side);

/**
 * Fill the lines of a pattern that has all the rest.
 */
void MakeLines(RefinementPattern& pattern);
}

#endif

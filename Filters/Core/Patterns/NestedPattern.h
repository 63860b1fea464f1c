// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   patterns with moving vertices, so that fractional levels change a surface smoothly
 *
 * A nested pattern belongs to the levels of the edges of a face whose corners are sorted by merged
 * point. relevoMorph.glsl computes the positions of its vertices from the edges' tags, which are
 * the levels before rounding. When a tag passes from one level to the next, both patterns cover the
 * face with the same triangles: additional vertices coincide with others. The refined surface is
 * therefore a continuous function of the tags, and no triangle ever flips.
 *
 * A pattern consists of a regular grid, bounded by three inner vertices near the corners, and a
 * strip of triangles along each edge. The vertices of a strip move along its two sides, which meet
 * only at the corners, so that edges and grid may have any levels. The level of the grid is the
 * median level of the edges, but at most one above the lowest level, and at least 2 if an edge has
 * this level. Strips join at the corners, where a regular grid would have a triangle.
 *
 * Levels (d, d, d) give 4^d triangles of equal area. The exception is (1, 1, 1), which has two more
 * triangles that are degenerate if the tag of edge 02 is not below that of edge 01: no fixed set of
 * four triangles can lose the midpoints of its edges in any order.
 *
 * @sa PatternLibrary RefinementPattern
 */
#ifndef NestedPattern_h
#define NestedPattern_h

#include "Patterns/RefinementPattern.h"

#include <array>

namespace relevo
{
/**
 * Return the nested pattern for the levels of the edges between the sorted corners 0, 1 and 2, each
 * in [0, 7]. P1, P2 and P3 are the corners 0, 1 and 2: edge 1 of the pattern is 01, edge 2 is 12,
 * edge 3 is 02. The weights are multiples of 1/128.
 */
RefinementPattern MakeNestedPattern(const std::array<int, 3>& levels);
}

#endif

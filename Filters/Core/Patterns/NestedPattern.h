// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   patterns whose vertices can move, so that fractional levels change a surface smoothly
 *
 * A nested pattern belongs to the levels of the edges of a face whose corners are sorted by place.
 * Its vertices stand where relevoMorph.glsl puts them for the edges' tags, the levels before they
 * are rounded. When a tag passes from one level to the next, the two patterns cover the face with
 * the same triangles: the vertices that one has in addition stand on others. So the refined surface
 * is a continuous function of the tags, and no triangle ever turns over.
 *
 * A pattern is a regular grid inside, bounded by three inner vertices near the corners, and a strip
 * of triangles along each edge. The vertices of a strip move along its two sides, which do not meet
 * but at the corners, so that edges and grid may have any levels. The grid's level is the middle
 * one of the edges, but at most one above the lowest and at least 2 when any edge has this level.
 * Strips join at the corners, where a regular grid would have a triangle across.
 *
 * Levels (d, d, d) give 4^d triangles, all of the same area, but for (1, 1, 1), which has two more
 * that are empty where the tag of edge 02 is not below that of edge 01: no fixed set of four
 * triangles can lose the middles of its edges in any order.
 *
 * Private to the module's own sources.
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
 * The nested pattern for the levels of the edges between the sorted corners 0, 1 and 2, each in
 * [0, 7], with P1, P2, P3 = corners 0, 1, 2: edge 1 of the pattern is 01, edge 2 is 12, edge 3 is
 * 02. Its weights are multiples of 1/128.
 */
RefinementPattern MakeNestedPattern(const std::array<int, 3>& levels);
}

#endif

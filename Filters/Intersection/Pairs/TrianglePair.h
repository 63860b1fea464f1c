// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where two triangles meet, told by their corners, edges and interiors
 *
 * What two triangles have in common is convex: nothing, a point, a segment or, of coplanar ones, a
 * polygon. Each of its corners is where a corner, edge or the interior of one triangle meets such a
 * part of the other, so that it is named without being computed, and by all triangles alike that
 * have these parts in common.
 *
 * Private to the module's own sources.
 */
#ifndef TrianglePair_h
#define TrianglePair_h

#include "Pairs/CommonPoints.h"

namespace relevo
{
/// The points of a triangle's corners; it has an area.
/**
 * What two triangles have in common, decided exactly.
 */
CommonPoints IntersectTriangles(const TrianglePoints& a, const TrianglePoints& b);
}

#endif

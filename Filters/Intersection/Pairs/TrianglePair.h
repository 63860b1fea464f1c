// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersection of two triangles, described by corners, edges and interiors
 *
 * The intersection is convex: empty, a point, a segment or, for coplanar triangles, a polygon. Each
 * of its corners is the intersection of a corner, edge or interior of one triangle with a part of
 * the other. This identifies the point without computing it, and identically for all triangles that
 * share these parts.
 *
 * Private to the module.
 */
#ifndef TrianglePair_h
#define TrianglePair_h

#include "Pairs/CommonPoints.h"

namespace relevo
{
/**
 * Computes the intersection with exact decisions. Both triangles must have an area.
 */
CommonPoints IntersectTriangles(const TrianglePoints& a, const TrianglePoints& b);
}

#endif

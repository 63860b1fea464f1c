// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersection of two coplanar triangles
 *
 * Private to the module.
 */
#ifndef CoplanarPair_h
#define CoplanarPair_h

#include "Pairs/CommonPoints.h"

namespace relevo
{
/// Returns the part of a triangle that contains a point of its plane.
TrianglePart FindPartInPlane(const double point[3], const TrianglePoints& triangle);

/// See IntersectTriangles().
CommonPoints IntersectCoplanarTriangles(const TrianglePoints& a, const TrianglePoints& b);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what two triangles in one plane have in common
 *
 * Private to the module's own sources.
 */
#ifndef CoplanarPair_h
#define CoplanarPair_h

#include "Pairs/CommonPoints.h"

namespace relevo
{
/// The part of a triangle that a point in its plane is in.
TrianglePart FindPartInPlane(const double point[3], const TrianglePoints& triangle);

/// See IntersectTriangles().
CommonPoints IntersectCoplanarTriangles(const TrianglePoints& a, const TrianglePoints& b);
}

#endif

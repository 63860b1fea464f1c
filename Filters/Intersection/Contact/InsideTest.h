// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether a point is inside a closed surface, decided exactly
 *
 * Private to the module's own sources.
 */
#ifndef InsideTest_h
#define InsideTest_h

namespace relevo
{
class MovedSurface;

/**
 * Whether a ray from the point crosses the surface an odd number of times. The point is not on the
 * surface.
 */
bool IsInside(const double point[3], const MovedSurface& surface);
}

#endif

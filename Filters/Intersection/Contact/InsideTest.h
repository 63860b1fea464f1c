// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   exact test whether a point is inside of a closed surface
 *
 * Private to the module.
 */
#ifndef InsideTest_h
#define InsideTest_h

namespace relevo
{
class MovedSurface;

/**
 * Whether a ray from the point crosses the surface an odd number of times. The point must not be on
 * the surface.
 */
bool IsInside(const double point[3], const MovedSurface& surface);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   how far a point is from the nearest of many boxes
 *
 * Private to the module's own sources.
 */
#ifndef NearestBox_h
#define NearestBox_h

namespace relevo
{
class BoxTree;

/// The distance over `reach`, at least 0, up to 1; 2 for all that is beyond, or has a coordinate
/// that is not finite. 0 in a box, its border being a part of it.
double GetBoxDistance(const BoxTree& tree, const double point[3], double reach);
}

#endif

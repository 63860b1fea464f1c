// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   distance of a point from the nearest of many boxes
 *
 * Private to the module.
 */
#ifndef NearestBox_h
#define NearestBox_h

namespace relevo
{
class BoxTree;

/// Returns distance / reach, from 0 in or on a box to 1, or 2 if the distance is larger or a
/// coordinate is not finite. `reach` is at least 0.
double GetBoxDistance(const BoxTree& tree, const double point[3], double reach);
}

#endif

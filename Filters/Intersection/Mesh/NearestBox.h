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

#include "Boxes/BoxTree.h"

namespace relevo
{
/// Returns distance / reach, from 0 in or on a box to 1, or 2 if the distance is larger or a
/// coordinate is not finite. `reach` is at least 0.
double GetBoxDistance(const DoubleBoxTree& tree, const double point[3], double reach);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which process draws which part of space
 *
 * Private to the module.
 */
#ifndef SpaceRegions_h
#define SpaceRegions_h

#include "vtkBoundingBox.h"

#include <vector>

namespace relevo
{
/**
 * Boxes that share all of space, one for each of `boxes`, grown until they meet; outer sides are at
 * VTK_DOUBLE_MAX. Planes that leave whole boxes on both sides part them, as those of a k-d tree do;
 * where there are none, boxes that overlap are cut. Who has no box, or one in the same place as
 * another, may get none (an invalid one).
 *
 * Where boxes meet, they part a little beside: faces like to lie in such planes, and would belong
 * to both sides.
 */
std::vector<vtkBoundingBox> ShareSpace(const std::vector<vtkBoundingBox>& boxes);
}

#endif

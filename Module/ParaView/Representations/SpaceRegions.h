// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   assigns a region of space to each process
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
 * Return boxes that partition space, one for each of `boxes`, grown until they touch; outer sides
 * are at VTK_DOUBLE_MAX. Like in a k-d tree, planes separate the boxes if they leave whole boxes on
 * both sides; otherwise overlapping boxes are cut. A missing box, or one that coincides with
 * another, may get an invalid region.
 *
 * Where boxes touch, the plane is moved slightly away, because faces often lie in such planes and
 * would belong to both sides.
 */
std::vector<vtkBoundingBox> ShareSpace(const std::vector<vtkBoundingBox>& boxes);
}

#endif

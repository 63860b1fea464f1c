// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a tree of boxes that a shader goes through without a stack
 *
 * Private to the modules' own sources.
 */
#ifndef BorderTree_h
#define BorderTree_h

#include "Boxes/BoxTree.h"

#include <vector>

namespace relevo
{
/**
 * The nodes of a tree, depth first, as eight floats each: the box's low corner; of an inner node
 * the node that follows when the box is missed, of a leaf its first face in the tree's order; the
 * high corner; the number of faces, 0 for an inner node. After a leaf follows the next node, and
 * after the last one the number of nodes. Boxes are widened by the margin. Numbers are whole, and
 * exact up to 2^24.
 */
std::vector<float> FlattenTree(const FloatBoxTree& tree, float margin);
}

#endif

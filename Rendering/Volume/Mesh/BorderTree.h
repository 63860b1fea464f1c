// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a bounding volume hierarchy that a shader traverses without a stack
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
 * Return the nodes of a tree in depth-first order, with eight floats each: the box's minimum
 * corner; for an inner node the node that follows if the box is missed, for a leaf its first face
 * in the tree's order; the maximum corner; the number of faces, 0 for an inner node. A leaf is
 * followed by the next node, the last leaf by the number of nodes. Boxes are enlarged by the
 * margin. Indices are whole numbers, exact up to 2^24.
 */
std::vector<float> FlattenTree(const FloatBoxTree& tree, float margin);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   choice of the diagonals of quadrilaterals
 *
 * Private to the module.
 */
#ifndef Diagonals_h
#define Diagonals_h

#include "Coarse/PatchEdges.h"

namespace relevo
{
enum class Diagonal : unsigned char
{
  None,
  First,  // from corner 0 to corner 2
  Second, // from corner 1 to corner 3
  Fixed   // the first, even if it duplicates an edge
};

/// Changes each First to Second or None if it would connect two merged points that an edge or
/// another diagonal connects. `places` has the merged points of the corners.
void ChooseDiagonals(const PatchEdges& edges, const std::vector<CornerPoints>& places,
  std::vector<Diagonal>& diagonals);
}

#endif

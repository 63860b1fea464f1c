// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how quadrilaterals become two triangles each
 *
 * Private to the module's own sources.
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
  Fixed   // the first, whatever it joins
};

/// Each First may become Second or None, so that no diagonal joins two places that an edge or
/// another diagonal joins.
void ChooseDiagonals(const PatchEdges& edges, const std::vector<CornerPoints>& places,
  std::vector<Diagonal>& diagonals);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pairs of intersecting cells, from pairs of triangles
 *
 * Private to the module.
 */
#ifndef CellPairs_h
#define CellPairs_h

#include "Pairs/PairSearch.h"

#include <vector> // for parameters

class vtkFieldData;

namespace relevo
{
class MovedSurface;

/**
 * Adds the arrays AllInput0CellID and AllInput1CellID with the distinct pairs, sorted. For the
 * self-intersection of a surface, the lower id comes first.
 */
void AddCellPairs(const MovedSurface& first, const MovedSurface& second,
  const std::vector<IntersectingPair>& pairs, vtkFieldData* data);
}

#endif

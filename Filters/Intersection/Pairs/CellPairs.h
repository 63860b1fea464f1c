// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   all pairs of cells that meet, of pairs of their triangles
 *
 * Private to the module's own sources.
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
 * Adds the arrays AllInput0CellID and AllInput1CellID: each pair once, sorted. Of a surface with
 * itself the lower id comes first.
 */
void AddCellPairs(const MovedSurface& first, const MovedSurface& second,
  const std::vector<IntersectingPair>& pairs, vtkFieldData* data);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   all pairs of triangles of two surfaces, or of one with itself, that meet
 *
 * Private to the module's own sources.
 */
#ifndef PairSearch_h
#define PairSearch_h

#include "Pairs/TrianglePair.h"
#include "RelevoFiltersIntersectionModule.h" // for export macro
#include "vtkType.h"                         // for vtkIdType

#include <vector> // for return values

namespace relevo
{
class MovedSurface;

struct IntersectingPair
{
  vtkIdType Triangles[2];
  CommonPoints Common;

  bool operator<(const IntersectingPair& other) const
  {
    return this->Triangles[0] != other.Triangles[0] ? this->Triangles[0] < other.Triangles[0]
                                                    : this->Triangles[1] < other.Triangles[1];
  }
};

/**
 * Sorted by triangles, those without an area left out. If both surfaces are the same object, the
 * first triangle is before the second, and the corner or the edge that they share is nothing.
 */
RELEVOFILTERSINTERSECTION_EXPORT std::vector<IntersectingPair> FindMeetingPairs(
  const MovedSurface& first, const MovedSurface& second);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   search for all intersecting pairs of triangles of two surfaces, or of one surface
 *
 * Private to the module.
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
 * Returns sorted pairs of triangles with an area. If both surfaces are the same object, the first
 * triangle precedes the second, and the shared corner or edge of adjacent triangles is ignored.
 */
RELEVOFILTERSINTERSECTION_EXPORT std::vector<IntersectingPair> FindMeetingPairs(
  const MovedSurface& first, const MovedSurface& second);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IntersectionPoints
 * @brief   the points where surfaces meet, each of them once
 *
 * A point is known by the parts of the surfaces that it is in: a place, an edge or a triangle of
 * each, known by their places. So a triangle that is there twice counts once. Its coordinates are a
 * quotient that is computed exactly and rounded once.
 *
 * Private to the module's own sources.
 */
#ifndef IntersectionPoints_h
#define IntersectionPoints_h

#include "Pairs/PairSearch.h"
#include "vtkType.h" // for vtkIdType

#include <array>  // for members
#include <vector> // for members

namespace relevo
{
class MovedSurface;

class IntersectionPoints
{
public:
  IntersectionPoints(const MovedSurface& first, const MovedSurface& second,
    const std::vector<IntersectingPair>& pairs);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Uses.size()); }
  /// The point of a pair's corner.
  vtkIdType GetId(std::size_t pair, int corner) const
  {
    return this->Ids[this->Firsts[pair] + corner];
  }
  /// Compute the coordinates of a point.
  void Compute(vtkIdType point, double x[3]) const;

private:
  // By which pair and corner a point was found first.
  struct Use
  {
    std::size_t Pair;
    int Corner;
  };
  // The places of a corner, an edge or a triangle, in order; -1 for those that are too many.
  using Part = std::array<vtkIdType, 3>;

  Part GetPart(const MovedSurface& surface, vtkIdType triangle, TrianglePart part) const;

  const MovedSurface* Surfaces[2];
  const std::vector<IntersectingPair>& Pairs;
  std::vector<Use> Uses;
  std::vector<std::size_t> Firsts; // per pair
  std::vector<vtkIdType> Ids;      // per corner of a pair
};
}

#endif

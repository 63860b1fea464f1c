// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IntersectionPoints
 * @brief   points of the intersection of two surfaces, without duplicates
 *
 * A point is identified by the vertex, edge or triangle of each surface that contains it. These are
 * identified by their merged points, so that duplicate triangles have no effect. Coordinates are a
 * quotient that is computed exactly and rounded once.
 *
 * Private to the module.
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
  /// Returns the point at a corner of the intersection of a pair.
  vtkIdType GetId(std::size_t pair, int corner) const
  {
    return this->Ids[this->Firsts[pair] + corner];
  }
  /// Computes the coordinates of a point.
  void Compute(vtkIdType point, double x[3]) const;

private:
  // The pair and corner where a point was found first.
  struct Use
  {
    std::size_t Pair;
    int Corner;
  };
  // The sorted merged points of a corner, an edge or a triangle, filled up with -1.
  using Part = std::array<vtkIdType, 3>;

  Part GetPart(const MovedSurface& surface, vtkIdType triangle, TrianglePart part) const;

  const MovedSurface* Surfaces[2];
  const std::vector<IntersectingPair>& Pairs;
  std::vector<Use> Uses;
  std::vector<std::size_t> Firsts; // one per pair
  std::vector<vtkIdType> Ids;      // one per corner of a pair
};
}

#endif

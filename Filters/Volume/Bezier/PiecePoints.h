// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PiecePoints
 * @brief   the points of linear pieces, merged with those of neighbours
 *
 * Points at a place get the same coordinates, to the bit. They are one point if their scalars are
 * equal too, up to rounding errors.
 *
 * Private to the module.
 */
#ifndef PiecePoints_h
#define PiecePoints_h

#include "Bezier/BezierHexahedron.h"
#include "Bezier/PlaceSet.h"
#include "Integral/ScalarTable.h"
#include "vtkType.h"

#include <vector>

namespace relevo
{
class PiecePoints
{
public:
  /// Points are appended to `positions` and `values`, which must outlive this object. Scalars that
  /// differ by at most `same` are equal.
  PiecePoints(
    PlaceSet& places, const Scalars& same, std::vector<dvec3>& positions, ScalarTable& values);

  /// Uses an existing point for new points at its place.
  void Reuse(vtkIdType point);
  /// Returns the id of a point that neighbours may share.
  vtkIdType Find(const BezierPoint& point);
  /// Adds a point that no neighbour has.
  vtkIdType Add(const BezierPoint& point);

private:
  vtkIdType Search(size_t place, const Scalars& values) const;
  void Append(size_t place, vtkIdType point);

  struct Entry
  {
    vtkIdType Point;
    size_t Next;
  };

  PlaceSet& Places;
  const Scalars Same;
  std::vector<dvec3>& Positions;
  ScalarTable& Values;
  std::vector<size_t> Firsts; // of each place, in Entries
  std::vector<Entry> Entries;
};
}

#endif

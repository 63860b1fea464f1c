// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SplitCounts
 * @brief   the numbers of linear pieces of Bézier hexahedra
 *
 * In a trilinear piece, positions and scalars differ from those of the Bézier hexahedron by at most
 * the sum, over the three parameters, of the largest second derivative / (8 count^2). Counts are
 * chosen so that this bound meets the tolerances. The four opposite edges of a hexahedron have the
 * same count. Hexahedra that share an edge therefore form sheets of equal counts, and the pieces of
 * neighbours match.
 *
 * Private to the module.
 */
#ifndef SplitCounts_h
#define SplitCounts_h

#include "Bezier/CurvedCells.h"

#include <array>
#include <vector>

namespace relevo
{
class PlaceSet;

/// The largest errors of linear pieces.
struct SplitTolerances
{
  double Shape; // length
  Scalars Values;
};

class SplitCounts
{
public:
  /// The largest count of a direction.
  static constexpr int LargestCount = 64;
  /// The largest number of pieces is the larger one of this number and PiecesPerPart times the
  /// number of parts.
  static constexpr double LargestTotal = 1 << 20;
  static constexpr double PiecesPerPart = 8.0;

  SplitCounts(
    const std::vector<CurvedPart>& parts, const SplitTolerances& tolerances, PlaceSet& places);

  const ivec3& Get(size_t part) const { return this->Counts[part]; }
  /// Whether the tolerances would need larger counts.
  bool AreLimited() const { return this->HasLimits; }

private:
  std::vector<ivec3> Counts;
  bool HasLimits = false;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleCounts
 * @brief   tables of the number of triangles of a family's patterns, for loops over faces
 */
#ifndef TriangleCounts_h
#define TriangleCounts_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <vector> // for members

namespace relevo
{
class PatternFamily;

class RELEVOFILTERSCORE_EXPORT TriangleCounts
{
public:
  /**
   * Create tables for edges up to a level. This generates the patterns, except for families of
   * whole numbers, which have too many: their counts are estimates.
   */
  TriangleCounts(const PatternFamily& family, int maximumLevel);

  bool AreEstimates() const { return this->Estimates; }

  /// Number of steps. The first has 1 segment, the last has 2^MaximumLevel.
  int GetNumberOfSteps() const { return static_cast<int>(this->MinimumTags.size()) - 1; }

  /// Per step, the lowest tag of edges with this step. The entry after the last step is infinity.
  const std::vector<float>& GetMinimumTags() const { return this->MinimumTags; }

  /**
   * Per index (step01 * n + step12) * n + step02 for n steps. More segments never have fewer
   * triangles here: the few patterns that have fewer get the count of the largest pattern below
   * them.
   */
  const std::vector<int>& GetTriangles() const { return this->Triangles; }

private:
  bool Estimates;
  std::vector<float> MinimumTags;
  std::vector<int> Triangles;
};
}

#endif

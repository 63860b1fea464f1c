// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleCounts
 * @brief   how many triangles the patterns of a family have, as tables for loops over faces
 *
 * Private to the module's own sources.
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
   * For edges up to a level. Makes the patterns, except of families of whole numbers: there are too
   * many, and the counts are estimates.
   */
  TriangleCounts(const PatternFamily& family, int maximumLevel);

  bool AreEstimates() const { return this->Estimates; }

  /// Number of steps, the first of 1 segment, the last of 2^MaximumLevel.
  int GetNumberOfSteps() const { return static_cast<int>(this->MinimumTags.size()) - 1; }

  /// By step: the tag from which on an edge takes it; infinity after the last step.
  const std::vector<float>& GetMinimumTags() const { return this->MinimumTags; }

  /**
   * By (step01 * n + step12) * n + step02 for n steps. More segments never mean fewer triangles
   * here: the few patterns that have fewer count as many as the largest of those below.
   */
  const std::vector<int>& GetTriangles() const { return this->Triangles; }

private:
  bool Estimates;
  std::vector<float> MinimumTags;
  std::vector<int> Triangles;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternExtents
 * @brief   how large the triangles of patterns are, in the directions of a face's corners
 *
 * Triangles of a pattern whose edges have n segments and more can be twice as long as 1 / n: a
 * bound must look at the pattern itself. Safe to call from several threads.
 *
 * Private to the module's own sources.
 */
#ifndef PatternExtents_h
#define PatternExtents_h

#include "Mathematics/RefinementMathematics.h"
#include "Patterns/PatternFamily.h"

#include <array>  // for steps
#include <memory> // for members
#include <mutex>  // for std::once_flag
#include <vector> // for members

namespace relevo
{
class PatternExtents
{
public:
  using Steps = std::array<int, 3>;

  /// Those of a family; nullptr for the whole numbers of segments of the patterns that Relevo
  /// makes. All who ask for a family share them.
  static std::shared_ptr<const PatternExtents> Find(std::shared_ptr<const PatternFamily> family);

  explicit PatternExtents(std::shared_ptr<const PatternFamily> family);

  const SegmentSteps& GetSegmentSteps() const { return this->Family->GetSegmentSteps(); }

  /// Whether vertices slide to their places while tags rise: see relevoMorph.glsl.
  bool AreMorphing() const { return this->Family->IsMorphing(); }

  /// The largest sum over corners c of form[c] times the square of what a triangle of the pattern
  /// spans of the weight of c. steps[c] is that of the edge opposite to c.
  double Measure(const Steps& steps, const dvec3& form) const;

private:
  struct Extents
  {
    std::once_flag Filled;
    /// Squares, of the weights of pattern corners, that no other triangle has all larger.
    std::vector<dvec3> Squares;
  };

  const std::vector<dvec3>& Get(const Steps& descending) const;
  std::vector<dvec3> Compute(const Steps& descending) const;

  std::shared_ptr<const PatternFamily> Family;
  mutable std::vector<Extents> Places;
};
}

#endif

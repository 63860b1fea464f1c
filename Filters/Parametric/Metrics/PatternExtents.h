// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternExtents
 * @brief   sizes of the triangles of patterns, in barycentric coordinates
 *
 * In a pattern whose edges have at least n segments, triangles can be twice as long as 1 / n. A
 * bound must therefore use the pattern itself. Thread-safe.
 *
 * Private to the module.
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

  /// Returns the extents of a family, shared by all users. nullptr selects Relevo's generated
  /// patterns with integer numbers of segments.
  static std::shared_ptr<const PatternExtents> Find(std::shared_ptr<const PatternFamily> family);

  explicit PatternExtents(std::shared_ptr<const PatternFamily> family);

  const SegmentSteps& GetSegmentSteps() const { return this->Family->GetSegmentSteps(); }

  /// Whether vertices are morphed while tags increase; see relevoMorph.glsl.
  bool AreMorphing() const { return this->Family->IsMorphing(); }

  /// Returns the maximum over the triangles of the pattern of the sum over corners c of form[c]
  /// times the squared range of the weight of c. steps[c] is the step of the edge opposite to c.
  double Measure(const Steps& steps, const dvec3& form) const;

private:
  struct Extents
  {
    std::once_flag Filled;
    /// Squared ranges by pattern corner, without those that another triangle dominates.
    std::vector<dvec3> Squares;
  };

  const std::vector<dvec3>& Get(const Steps& descending) const;
  std::vector<dvec3> Compute(const Steps& descending) const;

  std::shared_ptr<const PatternFamily> Family;
  mutable std::vector<Extents> Places;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::MeasuredPatterns
 * @brief   finds the patterns of faces, and caches how far they deviate from the surface
 */
#ifndef MeasuredPatterns_h
#define MeasuredPatterns_h

#include "Metrics/DisplacedFaces.h"        // for FaceDeviations
#include "RelevoFiltersRefinementModule.h" // for export macro

#include <array>      // for tags
#include <functional> // for Function
#include <memory>     // for members
#include <vector>     // for members

namespace relevo
{
class PatternFamily;
struct FacePattern;

class RELEVOFILTERSREFINEMENT_EXPORT MeasuredPatterns
{
public:
  using Function = std::function<FaceDeviations(const FacePattern&)>;

  MeasuredPatterns() = default;
  MeasuredPatterns(
    std::shared_ptr<const PatternFamily> patterns, int maximumLevel, std::size_t numberOfFaces);

  /**
   * Return the deviations of a face with the pattern for the tags of its sorted edges, or call
   * measure(pattern). `order` is the code of the permutation from the corners of the cell to the
   * sorted ones (CornerOrder.h). Thread-safe for different faces.
   */
  FaceDeviations Measure(
    int face, int order, const std::array<float, 3>& tags, const Function& measure);

private:
  struct Entry
  {
    unsigned int Key;
    FaceDeviations Deviations;
  };

  unsigned int GetKey(const int steps[3], const std::array<float, 3>& tags) const;

  std::shared_ptr<const PatternFamily> Family;
  int MaximumLevel = 0;
  std::vector<std::vector<Entry>> Entries; // per face
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternFamily
 * @brief   the patterns that faces choose from, and how they choose
 *
 * A family knows into how many segments an edge may be cut, its steps, and which pattern belongs to
 * the steps of a face's three edges. Faces that share a pattern and a winding share a key: they are
 * drawn together.
 *
 * Not wrapped: for the modules' own sources.
 */
#ifndef PatternFamily_h
#define PatternFamily_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <array>   // for members
#include <cstddef> // for size_t
#include <memory>  // for patterns
#include <vector>  // for members

class vtkRefinementPatternTable;

#ifndef __VTK_WRAP__
namespace relevo
{
struct RefinementPattern;
class RELEVOFILTERSREFINEMENT_EXPORT PatternFamily
{
public:
  /// 2^level segments for levels 0 to 7; canonical patterns, permuted (Lenz 2009, section 4.3).
  static const PatternFamily& GetPowersOfTwo();

  /// 1 to 16 segments, then 9 to 16 times 2, 4 and 8; canonical patterns, permuted.
  static const PatternFamily& GetWholeNumbers();

  /// 2^level segments; patterns of the sorted corners whose vertices morph (NestedPattern).
  static const PatternFamily& GetNested();

  /// Whether vertices of the patterns morph with the tags of the edges.
  bool IsMorphing() const { return this->Morphing; }

  int GetNumberOfSteps() const { return static_cast<int>(this->Segments.size()); }

  /// Segments of an edge at a step.
  int GetSegments(int step) const { return this->Segments[step]; }

  /// Whether edges take any whole number of segments. The step of an edge whose tag lies in
  /// [0, MaximumLevel] is then that of 2^tag segments, rounded half up; else it is its level.
  bool AreWholeNumbers() const { return this->Whole; }
  static int GetWholeNumberStep(float tag);

  int GetNumberOfKeys() const { return static_cast<int>(this->Keys.size()); }

  /**
   * For a face, by RefinementFace::Order and the steps of its sorted edges (0,1), (1,2), (0,2):
   * key << 3 | permutation code (relevoWeights.glsl).
   */
  unsigned int GetEntry(int order, int step01, int step12, int step02) const
  {
    const int n = this->GetNumberOfSteps();
    return this
      ->Entries[static_cast<std::size_t>(((order * n + step01) * n + step12) * n + step02)];
  }
  /// All entries, in the order of (order, step01, step12, step02).
  const std::vector<unsigned int>& GetEntries() const { return this->Entries; }

  /// Whether the triangles of a key's pattern are turned over.
  static bool IsMirrored(int key) { return (key & 1) != 0; }

  /// Steps of the pattern's edges 1, 2, 3.
  const std::array<unsigned char, 3>& GetSteps(int key) const { return this->Keys[key]; }

  std::shared_ptr<const RefinementPattern> GetPattern(
    int key, vtkRefinementPatternTable* table) const;

private:
  PatternFamily(std::vector<int> segments, bool morphing, bool whole);

  std::vector<int> Segments;
  bool Morphing;
  bool Whole;
  std::vector<std::array<unsigned char, 3>> Keys;
  std::vector<unsigned int> Entries;
};
}
#endif

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternFamily
 * @brief   a set of patterns for faces, and the rule to choose one
 *
 * A family defines the allowed numbers of segments of an edge, its steps, and the pattern for the
 * steps of a face's three edges. Faces with the same pattern and winding have the same key and are
 * drawn together. Patterns are generated on first use. All functions are thread-safe. Choosing a
 * pattern and getting one that exists take no lock.
 *
 * @sa PatternLibrary
 */
#ifndef PatternFamily_h
#define PatternFamily_h

#include "Patterns/SegmentSteps.h"   // for Steps
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkTimeStamp.h"            // for MakeTime

#include <array>      // for members
#include <cstddef>    // for size_t
#include <functional> // for PatternMaker
#include <memory>     // for patterns
#include <mutex>      // for std::once_flag
#include <vector>     // for members

namespace relevo
{
struct RefinementPattern;
class RELEVOFILTERSCORE_EXPORT PatternFamily
{
public:
  using Pattern = std::shared_ptr<const RefinementPattern>;

  /// Returns the pattern for the steps of its edges 1, 2 and 3.
  using PatternMaker = std::function<Pattern(const std::array<unsigned char, 3>&)>;

  /// How a pattern is identified.
  enum Kinds
  {
    /// The steps of its edges in descending order; other orders permute it (Lenz 2009, 4.3).
    CANONICAL,
    /// The steps of the edges between sorted corners; vertices morph (NestedPattern).
    MORPHING
  };

  PatternFamily(SegmentSteps steps, Kinds kind, PatternMaker make);
  ~PatternFamily();
  PatternFamily(const PatternFamily&) = delete;
  void operator=(const PatternFamily&) = delete;

  /// The time when the family was created, which is unique.
  vtkMTimeType GetMTime() const { return this->MakeTime; }

  /// Whether vertices of the patterns morph with the tags of the edges.
  bool IsMorphing() const { return this->Morphing; }

  const SegmentSteps& GetSegmentSteps() const { return this->Steps; }
  int GetNumberOfSteps() const { return this->Steps.GetNumberOfSteps(); }
  bool AreWholeNumbers() const { return this->Steps.AreWholeNumbers(); }

  int GetNumberOfKeys() const { return static_cast<int>(this->Keys.size()); }

  /**
   * Return key << 3 | permutation code (relevoWeights.glsl) for a face, from RefinementFace::Order
   * and the steps of its sorted edges (0,1), (1,2), (0,2).
   */
  unsigned int GetEntry(int order, int step01, int step12, int step02) const
  {
    const int n = this->GetNumberOfSteps();
    return this
      ->Entries[static_cast<std::size_t>(((order * n + step01) * n + step12) * n + step02)];
  }
  /// All entries, in the order of (order, step01, step12, step02).
  const std::vector<unsigned int>& GetEntries() const { return this->Entries; }

  /// Whether the triangles of a key's pattern are reversed.
  static bool IsMirrored(int key) { return (key & 1) != 0; }

  /// Steps of the pattern's edges 1, 2, 3.
  const std::array<unsigned char, 3>& GetSteps(int key) const { return this->Keys[key]; }

  /// The pattern of a key, the same object in each call.
  const Pattern& GetPattern(int key) const;

private:
  void MakeKeys();
  void MakeEntries();

  // A pattern that is generated once and never changes.
  struct Place
  {
    std::once_flag Filled;
    Pattern Content;
  };

  const SegmentSteps Steps;
  const bool Morphing;
  const PatternMaker Make;
  std::vector<std::array<unsigned char, 3>> Keys;
  std::vector<unsigned int> Entries;
  mutable std::vector<Place> Places; // by key / 2, because both windings share a pattern
  vtkTimeStamp MakeTime;
};
}

#endif

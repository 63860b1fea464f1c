// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MeasuredPatterns.h"

#include "Levels/EdgeLevels.h"
#include "Patterns/FacePattern.h"
#include "Patterns/PatternFamily.h"

#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// A view that moves for long needs ever more patterns. Each entry takes 20 bytes.
constexpr std::size_t MaximumNumberOfEntries = 64;
}

MeasuredPatterns::MeasuredPatterns(
  std::shared_ptr<const PatternFamily> patterns, int maximumLevel, std::size_t numberOfFaces)
  : Family(std::move(patterns))
  , MaximumLevel(maximumLevel)
  , Entries(numberOfFaces)
{
}

// Patterns that morph differ by the quarters of levels to which means of two tags can be rounded.
unsigned int MeasuredPatterns::GetKey(const int steps[3], const std::array<float, 3>& tags) const
{
  unsigned int key = 0;
  for (int e = 0; e < 3; ++e)
  {
    key = key << 8 |
      static_cast<unsigned int>(
        this->Family->IsMorphing() ? std::lround(4.0f * tags[e]) : long{ steps[e] });
  }
  return key;
}

FaceDeviations MeasuredPatterns::Measure(
  int face, int order, const std::array<float, 3>& given, const Function& measure)
{
  int steps[3];
  std::array<float, 3> tags;
  std::array<float, 3> morphTags;
  for (int e = 0; e < 3; ++e)
  {
    tags[e] = clampTag(given[e], 0.0f, this->MaximumLevel);
    steps[e] = this->Family->AreWholeNumbers() ? SegmentSteps::GetWholeNumberStep(tags[e])
                                               : levelOfTag(tags[e]);
    morphTags[e] = morphTag(tags[e], this->MaximumLevel);
  }
  const unsigned int key = this->GetKey(steps, tags);
  std::vector<Entry>& entries = this->Entries[face];
  for (const Entry& entry : entries)
  {
    if (entry.Key == key)
    {
      return entry.Deviations;
    }
  }
  const unsigned int entry = this->Family->GetEntry(order, steps[0], steps[1], steps[2]);
  const int patternKey = static_cast<int>(entry >> 3);
  const FacePattern pattern{ this->Family->GetPattern(patternKey).get(),
    static_cast<int>(entry & 7u), PatternFamily::IsMirrored(patternKey),
    this->Family->IsMorphing() ? morphTags.data() : nullptr };
  if (entries.size() >= MaximumNumberOfEntries)
  {
    entries.clear();
  }
  entries.push_back({ key, measure(pattern) });
  return entries.back().Deviations;
}
}

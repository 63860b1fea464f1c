// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/NestedPattern.h"

#include "Patterns/NestedPatternMesh.h"
#include "Patterns/RefinementPattern.h"
#include "Patterns/RefinementPatternGenerator.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

namespace
{
constexpr int NumberOfLevels = 8;

struct Patterns
{
  static constexpr std::size_t Count = NumberOfLevels * NumberOfLevels * NumberOfLevels;
  std::array<std::once_flag, Count> Made;
  std::array<relevo::RefinementPattern, Count> Patterns;
};
}

namespace relevo
{
const RefinementPattern& GetNestedPattern(int level01, int level12, int level02)
{
  static Patterns cache;
  std::size_t index = 0;
  std::array<int, 3> levels = { level01, level12, level02 };
  for (int& level : levels)
  {
    level = std::clamp(level, 0, NumberOfLevels - 1);
    index = index * NumberOfLevels + static_cast<std::size_t>(level);
  }
  RefinementPattern& pattern = cache.Patterns[index];
  std::call_once(cache.Made[index],
    [&]
    {
      const int segments[3] = { 1 << levels[0], 1 << levels[1], 1 << levels[2] };
      pattern = MakePattern(segments, MakeNestedMesh(levels));
    });
  return pattern;
}
}

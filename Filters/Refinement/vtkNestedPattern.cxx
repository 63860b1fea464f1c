// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNestedPattern.h"

#include "vtkNestedPatternMesh.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementPattern.h"
#include "vtkRefinementPatternGenerator.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

namespace relevo
{
#include "glsl/relevoMorph.glsl"
}

namespace
{
constexpr int NumberOfLevels = 8;

struct Patterns
{
  static constexpr std::size_t Count = NumberOfLevels * NumberOfLevels * NumberOfLevels;
  std::array<std::once_flag, Count> Made;
  std::array<vtkRefinementPattern, Count> Patterns;
};
}

namespace relevo
{
const vtkRefinementPattern& GetNestedPattern(int level01, int level12, int level02)
{
  static Patterns cache;
  std::size_t index = 0;
  std::array<int, 3> levels = { level01, level12, level02 };
  for (int& level : levels)
  {
    level = std::clamp(level, 0, NumberOfLevels - 1);
    index = index * NumberOfLevels + static_cast<std::size_t>(level);
  }
  vtkRefinementPattern& pattern = cache.Patterns[index];
  std::call_once(cache.Made[index],
    [&]
    {
      const int segments[3] = { 1 << levels[0], 1 << levels[1], 1 << levels[2] };
      pattern = MakePattern(segments, MakeNestedMesh(levels));
    });
  return pattern;
}

void MorphPattern(const vtkRefinementPattern& pattern, const float tags[3], int maximumLevel,
  std::vector<float>& weights)
{
  const vec3 effective(morphTag(tags[0], maximumLevel), morphTag(tags[1], maximumLevel),
    morphTag(tags[2], maximumLevel));
  weights.resize(pattern.Vertices.size());
  for (std::size_t i = 0; i < weights.size(); i += 3)
  {
    const float* exact = &pattern.Vertices[i];
    const vec3 moved = morphWeights(vec3(exact[0], exact[1], exact[2]), effective);
    weights[i] = moved.x;
    weights[i + 1] = moved.y;
    weights[i + 2] = moved.z;
  }
}
}

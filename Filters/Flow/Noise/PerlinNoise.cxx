// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Noise/PerlinNoise.h"

#include "Noise/NoiseHash.h"
#include "Noise/NoiseImage.h"

#include <algorithm>

namespace
{
float Fade(float t)
{
  return t * t * t * (t * (6.0f * t - 15.0f) + 10.0f);
}

// Returns the dot product of a random gradient, along an axis or a diagonal, and the offset.
float Slope(const relevo::uvec4& hash, const relevo::vec2& offset)
{
  constexpr float root2 = 1.41421356f;
  const float x = hash.x & 1u ? offset.x : -offset.x;
  const float y = hash.y & 1u ? offset.y : -offset.y;
  return hash.z & 1u ? x + y : root2 * (hash.w & 1u ? x : y);
}

// Returns gradient noise at p, on a lattice that repeats after n points.
float GradientNoise(const relevo::vec2& p, int n, int octave, int seed)
{
  const relevo::ivec2 cell(relevo::floor(p));
  const relevo::vec2 offset = p - relevo::vec2(cell);
  float corners[2][2];
  for (int j = 0; j < 2; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      const relevo::uvec4 hash = relevo::noiseHash(
        (cell.x + i) % n, (cell.y + j) % n, relevo::OCTAVE_STREAMS + octave, seed);
      corners[j][i] = Slope(hash, offset - relevo::vec2(i, j));
    }
  }
  const float fade = Fade(offset.x);
  return relevo::mix(relevo::mix(corners[0][0], corners[0][1], fade),
    relevo::mix(corners[1][0], corners[1][1], fade), Fade(offset.y));
}

// Returns the sum of the octaves, with mean 0.
float SumOctaves(int column, int row, int size, int period, int seed)
{
  float sum = 0.0f;
  float height = 1.0f;
  int n = std::max(1, (2 * size + period) / (2 * period));
  for (int octave = 0; octave == 0 || 2 * n <= size; ++octave, n *= 2, height *= 0.5f)
  {
    const float scale = static_cast<float>(n) / static_cast<float>(size);
    const relevo::vec2 p = scale * (relevo::vec2(column, row) + 0.5f);
    sum += height * GradientNoise(p, n, octave, seed);
  }
  return sum;
}
}

namespace relevo
{
std::vector<float> MakePerlinNoise(int size, int period, int seed)
{
  std::vector<float> image = MakeNoiseImage(
    size, [=](int column, int row) { return SumOctaves(column, row, size, period, seed); });
  const auto range = std::minmax_element(image.begin(), image.end());
  const float low = *range.first;
  const float width = std::max(*range.second - low, 1e-6f);
  for (float& value : image)
  {
    value = (value - low) / width;
  }
  return image;
}
}

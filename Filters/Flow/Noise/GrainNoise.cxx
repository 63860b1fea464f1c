// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Noise/GrainNoise.h"

#include "Noise/NoiseHash.h"
#include "Noise/NoiseImage.h"

#include <cmath>

namespace
{
constexpr float Mean = 0.41f;
constexpr float StandardDeviation = 0.159f;
constexpr double FilterReach = 3.0; // standard deviations

using Image = std::vector<float>;

Image Enlarge(const Image& grains, int numberOfGrains, int size, int grainSize)
{
  return relevo::MakeNoiseImage(size,
    [&](int column, int row)
    {
      return grains[static_cast<std::size_t>(row / grainSize) * numberOfGrains +
        column / grainSize];
    });
}

// Approximates a standard normal number by the sum of eight uniform numbers (Irwin and Hall). All
// operations are exact, so that the result does not depend on the processor.
float MakeNormal(const relevo::uvec4& hash)
{
  unsigned int sum = 0;
  for (int i = 0; i < 4; ++i)
  {
    sum += (hash[i] >> 16) + (hash[i] & 0xffffu);
  }
  return (static_cast<float>(sum) / 65536.0f - 4.0f) * 1.2247449f;
}

// Returns the weights of a Gaussian filter that preserves the variance of independent numbers.
Image MakeWeights(double standardDeviation)
{
  const int reach = static_cast<int>(std::ceil(FilterReach * standardDeviation));
  Image weights;
  double squares = 0.0;
  for (int k = -reach; k <= reach; ++k)
  {
    const double weight = k == 0 ? 1.0 : std::exp(-0.5 * std::pow(k / standardDeviation, 2.0));
    weights.push_back(static_cast<float>(weight));
    squares += weight * weight;
  }
  for (float& weight : weights)
  {
    weight = static_cast<float>(weight / std::sqrt(squares));
  }
  return weights;
}

// Filters along columns, periodically, and transposes the image. Applying it twice filters both
// directions.
Image FilterAndTranspose(const Image& image, int size, const Image& weights)
{
  const int reach = static_cast<int>(weights.size() / 2);
  return relevo::MakeNoiseImage(size,
    [&](int column, int row)
    {
      float sum = 0.0f;
      for (int k = -reach; k <= reach; ++k)
      {
        const int neighbour = ((row + k) % size + size) % size;
        sum += weights[k + reach] * image[static_cast<std::size_t>(column) * size + neighbour];
      }
      return sum;
    });
}
}

namespace relevo
{
std::vector<float> MakeUniformNoise(int size, int grainSize, int seed)
{
  return MakeNoiseImage(size,
    [=](int column, int row)
    { return noiseUniform(noiseHash(column / grainSize, row / grainSize, VALUE_STREAM, seed).x); });
}

std::vector<float> MakeGaussianNoise(int size, int grainSize, double smoothing, int seed)
{
  const int numberOfGrains = (size + grainSize - 1) / grainSize;
  const Image weights = MakeWeights(smoothing);
  Image grains = MakeNoiseImage(numberOfGrains,
    [=](int column, int row) { return MakeNormal(noiseHash(column, row, VALUE_STREAM, seed)); });
  grains = FilterAndTranspose(grains, numberOfGrains, weights);
  grains = FilterAndTranspose(grains, numberOfGrains, weights);
  for (float& value : grains)
  {
    value = Mean + StandardDeviation * value;
  }
  return Enlarge(grains, numberOfGrains, size, grainSize);
}
}

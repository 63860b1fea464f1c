// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightRanges
 * @brief   the lowest and highest height over a box of texture coordinates
 *
 * This is a pyramid of ranges over blocks of 1, 2, 4, ... texels. A query reads at most 3 x 3
 * blocks.
 */
#ifndef HeightRanges_h
#define HeightRanges_h

#include "Surfaces/HeightSampler.h"
#include "vtkHeightField.h"

#include <array>
#include <vector>

namespace relevo
{
class HeightRanges
{
public:
  /// The field must be up to date and outlive this object. nullptr is a field with one sample, 0.
  explicit HeightRanges(vtkHeightField* field);

  /// Get the range of all heights sampled in [low, high].
  void GetRange(vec2 low, vec2 high, float range[2]) const;

private:
  using Range = std::array<float, 2>;
  struct Level
  {
    ivec2 Size;
    std::vector<Range> Ranges;
    const Range& Get(int x, int y) const
    {
      return this->Ranges[static_cast<size_t>(y) * this->Size.x + x];
    }
  };
  Range GetTexels(ivec2 from, ivec2 to) const;

  HeightSampler Sampler;
  std::vector<Level> Levels; // for 2, 4, 8, ... texels
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/HeightRanges.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
namespace
{
template <typename GetBlock>
std::array<float, 2> Unite(ivec2 from, ivec2 to, const GetBlock& getBlock)
{
  std::array<float, 2> range = getBlock(from.x, from.y);
  for (int y = from.y; y <= to.y; ++y)
  {
    for (int x = from.x; x <= to.x; ++x)
    {
      const std::array<float, 2> block = getBlock(x, y);
      range[0] = std::min(range[0], block[0]);
      range[1] = std::max(range[1], block[1]);
    }
  }
  return range;
}
}

HeightRanges::HeightRanges(vtkHeightField* field)
  : Sampler(field)
{
  ivec2 size = this->Sampler.heightSize();
  while (size.x > 1 || size.y > 1)
  {
    const ivec2 last = size - ivec2(1);
    size = (size + ivec2(1)) / ivec2(2);
    Level level{ size, std::vector<Range>(static_cast<size_t>(size.x) * size.y) };
    const Level* below = this->Levels.empty() ? nullptr : &this->Levels.back();
    vtkSMPTools::For(0, size.y,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
        {
          for (int x = 0; x < size.x; ++x)
          {
            const ivec2 from = ivec2(2 * x, 2 * y);
            const ivec2 to = min(from + ivec2(1), last);
            level.Ranges[static_cast<size_t>(y) * size.x + x] = below
              ? Unite(from, to, [below](int i, int j) { return below->Get(i, j); })
              : this->GetTexels(from, to);
          }
        }
      });
    this->Levels.push_back(std::move(level));
  }
}

HeightRanges::Range HeightRanges::GetTexels(ivec2 from, ivec2 to) const
{
  return Unite(from, to,
    [this](int x, int y)
    {
      const float height = this->Sampler.heightTexel(ivec2(x, y));
      return Range{ { height, height } };
    });
}

void HeightRanges::GetRange(vec2 low, vec2 high, float range[2]) const
{
  HeightSampler sampler = this->Sampler; // a copy, because its shader functions are not const
  // One more texel on each side covers the rounding of coordinates between the corners.
  const ivec2 last = sampler.heightSize() - ivec2(1);
  ivec2 from = max(ivec2(floor(sampler.heightPosition(low))) - ivec2(1), ivec2(0));
  ivec2 to = min(ivec2(ceil(sampler.heightPosition(high))) + ivec2(1), last);
  size_t level = 0;
  while (level < this->Levels.size() && (to.x - from.x > 2 || to.y - from.y > 2))
  {
    from = from / ivec2(2);
    to = to / ivec2(2);
    ++level;
  }
  const Range found = level == 0
    ? this->GetTexels(from, to)
    : Unite(from, to, [&](int x, int y) { return this->Levels[level - 1].Get(x, y); });
  std::copy(found.begin(), found.end(), range);
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ReliefCones.h"

#include "Buffers/ReliefTiles.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// The cones of one tile.
class Cones
{
public:
  Cones(const ReliefTiles& tiles, int tile)
    : Stride(tiles.GetTilesPerRow() * ReliefTiles::Texels)
    , First(tiles.GetHeights().data() +
        static_cast<size_t>(tile / tiles.GetTilesPerRow()) * ReliefTiles::Texels * this->Stride +
        tile % tiles.GetTilesPerRow() * ReliefTiles::Texels)
  {
  }

  float FindRatio(const ivec2& texel) const
  {
    constexpr int last = ReliefTiles::Texels - 1;
    const ivec2 least = max(texel - ConeRadius, ivec2(0));
    const ivec2 most = min(texel + ConeRadius, ivec2(last));
    float ratio = Widest;
    for (int r = least.y; r <= most.y; ++r)
    {
      for (int c = least.x; c <= most.x; ++c)
      {
        if (texel != ivec2(c, r))
        {
          ratio = std::min(ratio, this->Limit(texel, ivec2(c, r)));
        }
      }
    }
    return ratio;
  }

private:
  static constexpr float Widest = 100.0f;

  float GetHeight(const ivec2& texel) const
  {
    return this->First[static_cast<size_t>(texel.y) * this->Stride + texel.x];
  }

  // Limit a cone by a horizontal ray into the surface at another texel: the cone must end before
  // the ray leaves the surface again. Steeper rays go deeper and do not leave the surface earlier.
  float Limit(const ivec2& texel, const ivec2& other) const
  {
    const float height = this->GetHeight(other);
    const float bottom = this->GetHeight(texel);
    if (height >= bottom)
    {
      return Widest;
    }
    const vec2 along = other - texel;
    const vec2 step = along / max(abs(along.x), abs(along.y));
    vec2 place = other;
    for (;;)
    {
      place += step;
      const ivec2 nearest(std::lround(place.x), std::lround(place.y));
      if (any(lessThan(nearest, ivec2(0))) ||
        any(greaterThanEqual(nearest, ivec2(ReliefTiles::Texels))))
      {
        return Widest;
      }
      if (this->GetHeight(nearest) > height)
      {
        return length(place - step - vec2(texel)) / (bottom - height);
      }
    }
  }

  const int Stride;
  const float* const First;
};
}

std::vector<unsigned char> MakeReliefCones(const ReliefTiles& tiles)
{
  std::vector<unsigned char> cones(tiles.GetHeights().size(), 0);
  const int perRow = tiles.GetTilesPerRow();
  vtkSMPTools::For(0, tiles.GetNumberOfTiles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int tile = static_cast<int>(begin); tile < end; ++tile)
      {
        const Cones ofTile(tiles, tile);
        const ivec2 corner = ivec2(tile % perRow, tile / perRow) * ReliefTiles::Texels;
        for (int i = 0; i < ReliefTiles::Texels * ReliefTiles::Texels; ++i)
        {
          const ivec2 texel(i % ReliefTiles::Texels, i / ReliefTiles::Texels);
          const float ratio = ofTile.FindRatio(texel);
          const size_t to = static_cast<size_t>(corner.y + texel.y) * perRow * ReliefTiles::Texels +
            corner.x + texel.x;
          // rounded down, so that cones are not wider
          cones[to] = static_cast<unsigned char>(255.0f * ratio / (1.0f + ratio));
        }
      }
    });
  return cones;
}
}

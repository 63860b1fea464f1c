// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ReliefTiles.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"
#include "vtkBoundingBox.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// The octahedral encoding of Cigolle et al., "A Survey of Efficient Representations for Independent
// Unit Vectors", 2014.
void PutNormal(const float* normal, unsigned short* out)
{
  dvec3 n(normal[0], normal[1], normal[2]);
  const double size = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  n = size > 0.0 && std::isfinite(size) ? n / size : dvec3(0.0, 0.0, 1.0);
  dvec2 place(n.x, n.y);
  if (n.z < 0.0)
  {
    place = dvec2((1.0 - std::abs(n.y)) * (n.x < 0.0 ? -1.0 : 1.0),
      (1.0 - std::abs(n.x)) * (n.y < 0.0 ? -1.0 : 1.0));
  }
  out[0] = static_cast<unsigned short>(std::lround((0.5 * place.x + 0.5) * 65535.0));
  out[1] = static_cast<unsigned short>(std::lround((0.5 * place.y + 0.5) * 65535.0));
}

// Return the height of a texel; empty texels get the height of their neighbours, so that searches
// that interpolate heights find the border of the surface. Return NaN if there is none.
double GetHeight(const Relief& relief, const ivec2& texel)
{
  const double height = relief.GetTexelHeight(texel.x, texel.y);
  if (std::isfinite(height))
  {
    return height;
  }
  const ivec2 least = max(texel - 1, ivec2(0));
  const ivec2 most = min(texel + 1, ivec2(relief.GetWidth(), relief.GetHeight()) - 1);
  double sum = 0.0;
  int number = 0;
  for (int r = least.y; r <= most.y; ++r)
  {
    for (int c = least.x; c <= most.x; ++c)
    {
      const double other = relief.GetTexelHeight(c, r);
      sum += std::isfinite(other) ? other : 0.0;
      number += std::isfinite(other) ? 1 : 0;
    }
  }
  return sum / number;
}
}

ivec2 ReliefTiles::GetTextureSize() const
{
  const int rows = (this->GetNumberOfTiles() + this->TilesPerRow - 1) / this->TilesPerRow;
  return ivec2(this->TilesPerRow, rows) * Texels;
}

void ReliefTiles::Cut(const Relief& relief, const std::vector<unsigned char>& sides)
{
  *this = ReliefTiles();
  this->FindFrame(relief);
  this->FindTiles(relief, sides);
  const size_t tiles = this->Origins.size();
  this->Places.resize(tiles);
  this->Quads.assign(tiles * Size / 2, 0);
  this->Ranges.resize(tiles * Cells * Cells * 2);
  this->Deviations.assign(tiles * HighestLevel, std::numeric_limits<float>::infinity());
  if (tiles == 0)
  {
    return;
  }
  this->TilesPerRow = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tiles))));
  const ivec2 size = this->GetTextureSize();
  const size_t texels = static_cast<size_t>(size.x) * size.y;
  this->Heights.assign(texels, 0.0f);
  this->Colors.assign(4 * texels, 0);
  this->Normals.assign(relief.GetNormals() ? 2 * texels : 0, 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(tiles),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int tile = static_cast<int>(begin); tile < end; ++tile)
      {
        this->FillTexels(relief, tile);
        this->FillTile(relief, sides, tile);
        this->FindDeviations(tile);
      }
    });
  this->FindNeighbors(relief);
}

void ReliefTiles::FindFrame(const Relief& relief)
{
  this->First = ivec2(relief.GetWidth() / 2, relief.GetHeight() / 2);
  const dvec2 range = relief.GetHeightRange();
  this->HeightOffset = 0.5 * (range.x + range.y);
  const dmat4& toWorld = relief.GetTexelToWorld();
  const dvec4 middle = toWorld * dvec4(this->First, this->HeightOffset, 1.0);
  const auto slope = [&](int axis)
  { return dvec3(toWorld[axis]) * middle.w - dvec3(middle) * toWorld[axis].w; };
  const double scale = length(slope(2)) / length(slope(0));
  this->HeightScale = std::isfinite(scale) && scale > 0.0 ? scale : 1.0;
  this->HeightScale *= relief.IsPerspective() ? -1.0 : 1.0;
  dmat4 toTexel(1.0);
  toTexel[2][2] = 1.0 / this->HeightScale;
  toTexel[3] = dvec4(this->First, this->HeightOffset, 1.0);
  this->ToWorld = (middle.w < 0.0 ? -1.0 : 1.0) * (toWorld * toTexel);
}

void ReliefTiles::FindTiles(const Relief& relief, const std::vector<unsigned char>& sides)
{
  const int width = relief.GetWidth();
  const int height = relief.GetHeight();
  const int components = relief.GetNumberOfColorComponents();
  vtkBoundingBox box;
  const auto isThere = [&](int c, int r)
  { return (sides[static_cast<size_t>(r) * width + c] & Quad) != 0; };
  for (int row = 0; row + 1 < height; row += Size)
  {
    for (int column = 0; column + 1 < width; column += Size)
    {
      bool found = false;
      for (int r = row; r < std::min(row + Size, height - 1); ++r)
      {
        for (int c = column; c < std::min(column + Size, width - 1); ++c)
        {
          if (!isThere(c, r))
          {
            continue;
          }
          found = true;
          for (int corner = 0; corner < 4; ++corner)
          {
            const ivec2 texel(c + corner % 2, r + corner / 2);
            const dvec3 point =
              relief.GetWorldPoint(texel.x, texel.y, relief.GetTexelHeight(texel.x, texel.y));
            box.AddPoint(point.x, point.y, point.z);
            this->Translucent = this->Translucent ||
              (components == 4 &&
                relief.GetColors()[4 * (static_cast<size_t>(texel.y) * width + texel.x) + 3] < 255);
          }
        }
      }
      if (found)
      {
        this->Origins.emplace_back(column, row);
      }
    }
  }
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
}

void ReliefTiles::FillTexels(const Relief& relief, int tile)
{
  const ivec2 origin = this->Origins[tile];
  const ivec2 corner = ivec2(tile % this->TilesPerRow, tile / this->TilesPerRow) * Texels;
  const int stride = this->TilesPerRow * Texels;
  const int components = relief.GetNumberOfColorComponents();
  for (int r = 0; r < std::min(Texels, relief.GetHeight() - origin.y); ++r)
  {
    for (int c = 0; c < std::min(Texels, relief.GetWidth() - origin.x); ++c)
    {
      const size_t to = static_cast<size_t>(corner.y + r) * stride + corner.x + c;
      const size_t from = static_cast<size_t>(origin.y + r) * relief.GetWidth() + origin.x + c;
      const double height = GetHeight(relief, origin + ivec2(c, r));
      this->Heights[to] = std::isfinite(height) ? static_cast<float>(this->ToScaled(height)) : 0.0f;
      const unsigned char* color = relief.GetColors() + components * from;
      for (int i = 0; i < 4; ++i)
      {
        this->Colors[4 * to + i] = i < components ? color[i] : 255;
      }
      if (relief.GetNormals())
      {
        PutNormal(relief.GetNormals() + 3 * from, this->Normals.data() + 2 * to);
      }
    }
  }
}

void ReliefTiles::FillTile(const Relief& relief, const std::vector<unsigned char>& sides, int tile)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const ivec2 origin = this->Origins[tile];
  const ivec2 corner = ivec2(tile % this->TilesPerRow, tile / this->TilesPerRow) * Texels;
  const size_t stride = static_cast<size_t>(this->TilesPerRow) * Texels;
  float* ranges = this->Ranges.data() + static_cast<size_t>(tile) * Cells * Cells * 2;
  for (int i = 0; i < Cells * Cells; ++i)
  {
    ranges[2 * i] = infinity;
    ranges[2 * i + 1] = -infinity;
  }
  vec2 all(infinity, -infinity);
  for (int r = 0; r < std::min(Size, relief.GetHeight() - 1 - origin.y); ++r)
  {
    for (int c = 0; c < std::min(Size, relief.GetWidth() - 1 - origin.x); ++c)
    {
      const size_t texel = static_cast<size_t>(origin.y + r) * relief.GetWidth() + origin.x + c;
      if (!(sides[texel] & Quad))
      {
        continue;
      }
      this->Quads[static_cast<size_t>(tile) * Size / 2 + r / 2] |= 1u << (r % 2 * Size + c);
      const float* heights = this->Heights.data() + (corner.y + r) * stride + corner.x + c;
      const float least =
        min(min(heights[0], heights[1]), min(heights[stride], heights[stride + 1]));
      const float most =
        max(max(heights[0], heights[1]), max(heights[stride], heights[stride + 1]));
      float* range = ranges + 2 * (r / CellSize * Cells + c / CellSize);
      range[0] = min(range[0], least);
      range[1] = max(range[1], most);
      all = vec2(min(all.x, least), max(all.y, most));
    }
  }
  this->Places[tile] = vec4(origin - this->First, all);
}

void ReliefTiles::FindNeighbors(const Relief& relief)
{
  // The grid has one more empty square in each direction.
  this->GridSize = ivec2(relief.GetWidth(), relief.GetHeight()) / Size + 2;
  this->Grid.assign(static_cast<size_t>(this->GridSize.x) * this->GridSize.y, -1);
  const auto at = [&](const ivec2& origin) -> int&
  { return this->Grid[static_cast<size_t>(origin.y / Size) * this->GridSize.x + origin.x / Size]; };
  for (size_t tile = 0; tile < this->Origins.size(); ++tile)
  {
    at(this->Origins[tile]) = static_cast<int>(tile);
  }
  for (const ivec2& origin : this->Origins)
  {
    this->Neighbors.emplace_back(at(origin + ivec2(Size, 0)), at(origin + ivec2(0, Size)));
  }
}

// The triangles are regular, with hypotenuses that rise to the right, like those of the patterns.
void ReliefTiles::FindDeviations(int tile)
{
  const unsigned int* quads = this->Quads.data() + static_cast<size_t>(tile) * Size / 2;
  if (std::any_of(quads, quads + Size / 2, [](unsigned int rows) { return rows != ~0u; }))
  {
    return;
  }
  const ivec2 corner = ivec2(tile % this->TilesPerRow, tile / this->TilesPerRow) * Texels;
  const auto height = [&](const ivec2& place)
  {
    const ivec2 texel = corner + place;
    return this->Heights[static_cast<size_t>(texel.y) * this->TilesPerRow * Texels + texel.x];
  };
  for (int level = 0; level < HighestLevel; ++level)
  {
    const int step = Size >> level;
    float most = 0.0f;
    for (int i = 0; i < Texels * Texels; ++i)
    {
      const ivec2 place(i % Texels, i / Texels);
      const ivec2 first = min(place / step, ivec2((1 << level) - 1)) * step;
      const vec2 part = vec2(place - first) / static_cast<float>(step);
      const bool isRight = part.x > part.y;
      const float h00 = height(first);
      const float h11 = height(first + step);
      const float other = height(first + (isRight ? ivec2(step, 0) : ivec2(0, step)));
      const float between = isRight ? h00 + part.x * (other - h00) + part.y * (h11 - other)
                                    : h00 + part.y * (other - h00) + part.x * (h11 - other);
      most = max(most, abs(between - height(place)));
    }
    this->Deviations[static_cast<size_t>(tile) * HighestLevel + level] = most;
  }
}
}

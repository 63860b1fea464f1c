// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/FaceHeights.h"

#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
float Mix(float a, float b, float t)
{
  return a + t * (b - a);
}
}

float GetLatticeHeight(const HeightTile& tile, int level, std::int64_t x, std::int64_t y)
{
  const std::int64_t first[2] = { static_cast<std::int64_t>(tile.Column) * HeightTile::CellsPerTile,
    static_cast<std::int64_t>(tile.Row) * HeightTile::CellsPerTile };
  const int shift = tile.Level - level;
  const std::int64_t mask = (std::int64_t(1) << shift) - 1;
  const int i = static_cast<int>((x >> shift) - first[0]);
  const int j = static_cast<int>((y >> shift) - first[1]);
  const float scale = std::ldexp(1.0f, -shift);
  const float u = static_cast<float>(x & mask) * scale;
  const float v = static_cast<float>(y & mask) * scale;
  // Vertices without weight may lack data.
  const auto interpolate = [&](int row)
  {
    const float height = tile.GetHeight(i, row);
    return u > 0.0f ? Mix(height, tile.GetHeight(i + 1, row), u) : height;
  };
  const float height = interpolate(j);
  return v > 0.0f ? Mix(height, interpolate(j + 1), v) : height;
}

FaceHeights::FaceHeights(const TerrainFace& face)
  : Face(face)
{
}

float FaceHeights::GetFine(int a, int b) const
{
  const std::array<std::int64_t, 2> vertex = this->Face.GetVertex(a, b);
  return GetLatticeHeight(*this->Face.Tile, this->Face.Level, vertex[0], vertex[1]);
}

// The vertex exists in the lattice of the next coarser level, too.
float FaceHeights::GetCoarse(int a, int b) const
{
  const std::array<std::int64_t, 2> vertex = this->Face.GetVertex(a, b);
  return GetLatticeHeight(
    *this->Face.CoarseTile, this->Face.Level + 1, vertex[0] / 2, vertex[1] / 2);
}

// The height of a vertex that the parent had, too. The corners (Segments, 0) and (0, Segments) are
// corners of the parent.
float FaceHeights::GetSource(int a, int b) const
{
  if (a == TerrainFace::Segments)
  {
    return this->Face.CornerHeights[1];
  }
  if (b == TerrainFace::Segments)
  {
    return this->Face.CornerHeights[2];
  }
  return this->Face.Made == TerrainFace::Origin::Square || b == 0 ? this->GetCoarse(a, b)
                                                                  : this->GetFine(a, b);
}

float FaceHeights::GetHeight(int a, int b) const
{
  const TerrainFace& f = this->Face;
  if (a + b == 0 || a == TerrainFace::Segments || b == TerrainFace::Segments)
  {
    return f.CornerHeights[a == TerrainFace::Segments ? 1 : b == TerrainFace::Segments ? 2 : 0];
  }
  const bool isOnLongestSide = a + b == TerrainFace::Segments;
  const float target = isOnLongestSide && f.Made == TerrainFace::Origin::Square
    ? this->GetCoarse(a, b)
    : this->GetFine(a, b);
  if (f.Morph >= 1.0f || isOnLongestSide)
  {
    return target;
  }
  AddedVertex added;
  if (this->FindAdded(a, b, added))
  {
    return Mix(0.5f * (added.Sources[0] + added.Sources[1]), target, f.Morph);
  }
  const float source =
    (a + b) % 2 == 0 ? this->GetSource(a, b) : std::numeric_limits<float>::quiet_NaN();
  return std::isnan(source) ? target : Mix(source, target, f.Morph);
}

bool FaceHeights::FindAdded(int a, int b, AddedVertex& added) const
{
  if ((a + b) % 2 == 0 || this->Face.Morph >= 1.0f)
  {
    return false;
  }
  const int i = a % 2;
  const int j = b % 2;
  added = { { this->GetSource(a - i, b - j), this->GetSource(a + i, b + j) }, this->GetFine(a, b) };
  return !std::isnan(added.Sources[0] + added.Sources[1]);
}
}

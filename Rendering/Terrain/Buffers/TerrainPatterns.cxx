// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainPatterns.h"

#include "Bisection/TerrainFace.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>

namespace relevo
{
namespace
{
constexpr int VerticesPerCopy = 256; // numbers of vertices; only some are used
constexpr int NumberOfCopies = 8;

unsigned short GetIndex(int firstVertex, int a, int b)
{
  return static_cast<unsigned short>(firstVertex + a + 16 * b);
}

void AppendTerrainPattern(std::vector<unsigned short>& indices, int firstVertex,
  TerrainPatterns::Primitives primitives, bool isMirrored)
{
  std::set<unsigned short> points;
  std::set<std::array<unsigned short, 2>> lines;
  for (const TerrainFace::PatternTriangle& triangle : TerrainFace::GetPattern())
  {
    std::array<unsigned short, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = GetIndex(firstVertex, triangle[i][0], triangle[i][1]);
    }
    points.insert(corners.begin(), corners.end());
    for (int i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      lines.insert({ { low, high } });
    }
    if (primitives == TerrainPatterns::TRIANGLES)
    {
      indices.insert(
        indices.end(), { corners[0], corners[isMirrored ? 2 : 1], corners[isMirrored ? 1 : 2] });
    }
  }
  if (primitives == TerrainPatterns::POINTS)
  {
    indices.insert(indices.end(), points.begin(), points.end());
  }
  else if (primitives == TerrainPatterns::LINES)
  {
    for (const std::array<unsigned short, 2>& line : lines)
    {
      indices.insert(indices.end(), line.begin(), line.end());
    }
  }
}
}

const PatternRange& TerrainPatterns::GetRange(Primitives primitives, bool isMirrored)
{
  return this->Ranges.Require({ primitives, isMirrored }, VerticesPerCopy, NumberOfCopies,
    [=](std::vector<unsigned short>& indices, int firstVertex)
    { AppendTerrainPattern(indices, firstVertex, primitives, isMirrored); });
}

bool TerrainPatterns::Bind()
{
  if (!this->Ranges.Upload())
  {
    return false;
  }
  this->Ranges.Bind();
  return true;
}
}

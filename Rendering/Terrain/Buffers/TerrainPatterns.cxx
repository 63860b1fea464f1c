// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainPatterns.h"

#include "Bisection/TerrainFace.h"

#include <array>
#include <initializer_list>

namespace relevo
{
namespace
{
constexpr int Segments = TerrainFace::Segments;
constexpr int VerticesPerCopy = 256; // of which most do not exist
constexpr int NumberOfCopies = 8;

unsigned short GetIndex(int firstVertex, int a, int b)
{
  return static_cast<unsigned short>(firstVertex + a + 16 * b);
}

void AppendTerrainPattern(std::vector<unsigned short>& indices, int firstVertex,
  TerrainPatterns::Primitives primitives, bool isMirrored)
{
  const auto addTriangle = [&](std::array<unsigned short, 3> corners)
  {
    indices.insert(
      indices.end(), { corners[0], corners[isMirrored ? 2 : 1], corners[isMirrored ? 1 : 2] });
  };
  for (int b = 0; b <= Segments; ++b)
  {
    for (int a = 0; a <= Segments - b; ++a)
    {
      const unsigned short here = GetIndex(firstVertex, a, b);
      const unsigned short along = GetIndex(firstVertex, a + 1, b);
      const unsigned short across = GetIndex(firstVertex, a, b + 1);
      if (primitives == TerrainPatterns::POINTS)
      {
        indices.push_back(here);
      }
      else if (a + b < Segments && primitives == TerrainPatterns::LINES)
      {
        indices.insert(indices.end(), { here, along, along, across, across, here });
      }
      else if (a + b < Segments)
      {
        addTriangle({ { here, along, across } });
        if (a + b < Segments - 1)
        {
          addTriangle({ { along, GetIndex(firstVertex, a + 1, b + 1), across } });
        }
      }
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

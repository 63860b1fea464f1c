// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternSides.h"

#include "Patterns/RefinementPattern.h"

#include <algorithm>
#include <cstddef>

namespace relevo
{
std::vector<PatternSide> SortedSides(const std::vector<unsigned int>& triangles)
{
  std::vector<PatternSide> sides;
  sides.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sides.push_back({ triangles[t + i], triangles[t + (i + 1) % 3] });
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::vector<PatternSide> BorderSides(const int segments[3])
{
  std::vector<PatternSide> sides;
  unsigned int next = 3;
  for (unsigned int edge = 0; edge < 3; ++edge)
  {
    unsigned int last = edge;
    for (int k = 1; k < segments[edge]; ++k)
    {
      sides.push_back({ last, next });
      last = next++;
    }
    sides.push_back({ last, (edge + 1) % 3 });
  }
  return sides;
}

bool Contains(const std::vector<PatternSide>& sorted, PatternSide side)
{
  return std::binary_search(sorted.begin(), sorted.end(), side);
}

void MakeLines(RefinementPattern& pattern)
{
  pattern.Lines.clear();
  for (const auto& [a, b] : BorderSides(pattern.Segments))
  {
    pattern.Lines.insert(pattern.Lines.end(), { a, b });
  }
  // An inner side occurs twice, once in each direction. A border side occurs once.
  const auto sides = SortedSides(pattern.Triangles);
  for (const auto& [a, b] : sides)
  {
    if (a < b && Contains(sides, { b, a }))
    {
      pattern.Lines.insert(pattern.Lines.end(), { a, b });
    }
  }
}
}

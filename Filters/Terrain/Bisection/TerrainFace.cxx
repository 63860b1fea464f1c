// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/TerrainFace.h"

#include <utility>

namespace relevo
{
namespace
{
using Pattern =
  std::array<TerrainFace::PatternTriangle, TerrainFace::Segments * TerrainFace::Segments>;

// Adds the parts of a triangle whose longest side is between the second and the third vertex.
void AddParts(
  const TerrainFace::PatternTriangle& triangle, int bisections, Pattern& pattern, int& number)
{
  if (bisections == 0)
  {
    pattern[number] = triangle;
    ++number;
    return;
  }
  const auto& [apex, first, second] = triangle;
  const std::array<int, 2> middle = { { (first[0] + second[0]) / 2, (first[1] + second[1]) / 2 } };
  AddParts({ { middle, apex, first } }, bisections - 1, pattern, number);
  AddParts({ { middle, second, apex } }, bisections - 1, pattern, number);
}
}

const Pattern& TerrainFace::GetPattern()
{
  static const Pattern pattern = []
  {
    Pattern parts;
    int number = 0;
    AddParts({ { { { 0, 0 } }, { { Segments, 0 } }, { { 0, Segments } } } }, 6, parts, number);
    return parts;
  }();
  return pattern;
}
}

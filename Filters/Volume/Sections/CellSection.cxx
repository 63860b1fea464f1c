// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/CellSection.h"

namespace relevo
{
void CellSection::Add(const PolyhedronSection& cut, const std::vector<int>& points,
  const std::vector<unsigned char>& isOuter)
{
  const auto areSame = [&](int a, int b) { return this->Points[a] == this->Points[b]; };
  for (const std::vector<int>& edges : cut.Polygons)
  {
    std::vector<int> polygon;
    for (const int edge : edges)
    {
      if (polygon.empty() || !areSame(polygon.back(), points[edge]))
      {
        polygon.push_back(points[edge]);
      }
    }
    while (polygon.size() > 1 && areSame(polygon.front(), polygon.back()))
    {
      polygon.pop_back();
    }
    if (polygon.size() >= 3)
    {
      this->Polygons.push_back(polygon);
    }
  }
  for (const FaceSegment& segment : cut.Segments)
  {
    const std::array<int, 2> line{ points[segment.Edges[0]], points[segment.Edges[1]] };
    if (isOuter[segment.Face] && !areSame(line[0], line[1]))
    {
      this->Lines.push_back(line);
    }
  }
}
}

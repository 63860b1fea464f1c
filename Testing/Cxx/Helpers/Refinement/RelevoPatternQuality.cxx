// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatternQuality.h"

#include <algorithm>
#include <cmath>

namespace RelevoPatternQuality
{
std::vector<Shape> GetShapes(const relevo::RefinementPattern& pattern)
{
  std::vector<Shape> shapes;
  for (std::size_t t = 0; t < pattern.Triangles.size(); t += 3)
  {
    double x[3], y[3];
    for (int i = 0; i < 3; ++i)
    {
      const float* w = &pattern.Vertices[3 * pattern.Triangles[t + i]];
      x[i] = w[1] + 0.5 * w[2];
      y[i] = std::sqrt(0.75) * w[2];
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    Shape shape = { area / std::sqrt(0.75), 180.0, 0.0 };
    double longest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double dot = (x[j] - x[i]) * (x[k] - x[i]) + (y[j] - y[i]) * (y[k] - y[i]);
      shape.SmallestAngle =
        std::min(shape.SmallestAngle, 180.0 / 3.14159265358979323846 * std::atan2(area, dot));
      longest = std::max(longest, std::hypot(x[j] - x[i], y[j] - y[i]));
    }
    shape.Aspect = longest * longest / area;
    shapes.push_back(shape);
  }
  return shapes;
}

relevo::RefinementPattern MakeSuaptPattern(vtkRefinementPatternTable* table, const int levels[3])
{
  const int n = 1 << levels[0];
  relevo::RefinementPattern pattern = *table->GetPatternOfSegments(n, n, n);
  std::size_t vertex = 3;
  for (int edge = 0; edge < 3; ++edge)
  {
    const int segments = 1 << levels[edge];
    for (int k = 1; k < n; ++k, ++vertex)
    {
      const float far = static_cast<float>((2 * k * segments + n) / (2 * n)) / segments;
      pattern.Vertices[3 * vertex + edge] = 1.0f - far;
      pattern.Vertices[3 * vertex + (edge + 1) % 3] = far;
    }
  }
  return pattern;
}
}

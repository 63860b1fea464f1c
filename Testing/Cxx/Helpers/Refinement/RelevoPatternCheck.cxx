// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatternCheck.h"

#include <algorithm>
#include <map>
#include <set>

namespace RelevoPatternCheck
{
Triple Weights(const relevo::RefinementPattern& pattern, unsigned int vertex)
{
  const float* weights = &pattern.Vertices[3 * vertex];
  return { weights[0], weights[1], weights[2] };
}

double Area(const Triple& a, const Triple& b, const Triple& c)
{
  return (static_cast<double>(b[1]) - a[1]) * (static_cast<double>(c[2]) - a[2]) -
    (static_cast<double>(c[1]) - a[1]) * (static_cast<double>(b[2]) - a[2]);
}

std::vector<unsigned int> EdgeVertices(const relevo::RefinementPattern& pattern, int edge)
{
  unsigned int next = 3;
  for (int before = 0; before < edge; ++before)
  {
    next += pattern.Segments[before] - 1;
  }
  std::vector<unsigned int> vertices(1, edge);
  for (int k = 1; k < pattern.Segments[edge]; ++k)
  {
    vertices.push_back(next++);
  }
  vertices.push_back((edge + 1) % 3);
  return vertices;
}

void CheckVertices(RelevoCheck& check, const relevo::RefinementPattern& pattern)
{
  const unsigned int count = pattern.GetNumberOfVertices();
  std::set<Triple> places;
  bool sums = true;
  bool inside = true;
  for (unsigned int vertex = 0; vertex < count; ++vertex)
  {
    const Triple w = Weights(pattern, vertex);
    places.insert(w);
    sums = sums && (w[0] + w[1]) + w[2] == 1.0f && (w[1] + w[2]) + w[0] == 1.0f &&
      (w[2] + w[0]) + w[1] == 1.0f;
    const bool isInner = static_cast<int>(vertex) >= pattern.GetNumberOfBorderVertices();
    inside = inside && isInner == (w[0] > 0.0f && w[1] > 0.0f && w[2] > 0.0f);
  }
  CHECK(sums);
  CHECK(inside);
  CHECK_EQUAL(places.size(), count);

  for (int edge = 0; edge < 3; ++edge)
  {
    const int n = pattern.Segments[edge];
    const bool isDyadic = (n & (n - 1)) == 0;
    const std::vector<unsigned int> vertices = EdgeVertices(pattern, edge);
    for (int k = 0; k <= n; ++k)
    {
      const Triple w = Weights(pattern, vertices[k]);
      const Triple mirror = Weights(pattern, vertices[n - k]);
      const float far = w[(edge + 1) % 3];
      CHECK_EQUAL(w[(edge + 2) % 3], 0.0f);
      CHECK_EQUAL(far, mirror[edge]);
      CHECK_NEAR(far, static_cast<double>(k) / n, isDyadic ? 0.0 : 0x1p-25);
    }
  }
}

void CheckTriangles(RelevoCheck& check, const relevo::RefinementPattern& pattern)
{
  std::map<Side, int> sides;
  double area = 0.0;
  bool positive = true;
  for (std::size_t t = 0; t < pattern.Triangles.size(); t += 3)
  {
    const unsigned int* triangle = &pattern.Triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      if (!CHECK_LESS(static_cast<int>(triangle[i]), pattern.GetNumberOfVertices()))
      {
        return;
      }
      ++sides[{ triangle[i], triangle[(i + 1) % 3] }];
    }
    const double triangleArea = Area(
      Weights(pattern, triangle[0]), Weights(pattern, triangle[1]), Weights(pattern, triangle[2]));
    positive = positive && triangleArea > 0.0;
    area += triangleArea;
  }
  CHECK(positive);
  CHECK_EQUAL(area, 1.0);

  // In a conforming triangulation, the sides used in one direction only form the border, segment by
  // segment.
  std::set<Side> open;
  std::set<Side> undirected;
  bool once = true;
  for (const auto& entry : sides)
  {
    const Side side = entry.first;
    once = once && entry.second == 1;
    undirected.insert(std::minmax(side.first, side.second));
    if (!sides.count({ side.second, side.first }))
    {
      open.insert(side);
    }
  }
  CHECK(once);
  std::vector<Side> border;
  for (int edge = 0; edge < 3; ++edge)
  {
    const std::vector<unsigned int> vertices = EdgeVertices(pattern, edge);
    for (std::size_t k = 1; k < vertices.size(); ++k)
    {
      border.push_back({ vertices[k - 1], vertices[k] });
    }
  }
  CHECK_EQUAL(open, std::set<Side>(border.begin(), border.end()));

  std::set<Side> lines;
  for (std::size_t l = 0; l < pattern.Lines.size(); l += 2)
  {
    lines.insert(std::minmax(pattern.Lines[l], pattern.Lines[l + 1]));
  }
  CHECK_EQUAL(2 * lines.size(), pattern.Lines.size());
  CHECK_EQUAL(lines, undirected);
  for (std::size_t l = 0; l < border.size(); ++l)
  {
    CHECK_EQUAL(Side(pattern.Lines[2 * l], pattern.Lines[2 * l + 1]), border[l]);
  }
}
}

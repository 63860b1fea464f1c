// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternCheck.h"

#include "Patterns/PatternBorder.h"
#include "Patterns/PatternPoint.h"
#include "Patterns/PatternSides.h"
#include "Patterns/RefinementPattern.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
using namespace relevo;

/// Converts weights to integers. Returns false if they are not multiples of 1 / WeightScale with
/// sum 1.
bool GetExactWeights(const float* weights, PatternWeights& exact)
{
  for (int i = 0; i < 3; ++i)
  {
    const float scaled = weights[i] * static_cast<float>(WeightScale);
    if (!(scaled >= 0.0f && scaled <= static_cast<float>(WeightScale)))
    {
      return false;
    }
    exact[i] = static_cast<std::int64_t>(scaled);
    if (static_cast<float>(exact[i]) != scaled)
    {
      return false;
    }
  }
  return exact[0] + exact[1] + exact[2] == WeightScale;
}

/// Checks the vertices and returns their points, in units of 1 / WeightScale.
const char* FindDefectOfVertices(
  const RefinementPattern& pattern, std::vector<PatternPoint>& points)
{
  const auto border = MakeBorderVertices(pattern.Segments, WeightScale);
  const std::size_t numberOfVertices = pattern.Vertices.size() / 3;
  points.reserve(numberOfVertices);
  for (std::size_t i = 0; i < numberOfVertices; ++i)
  {
    PatternWeights weights;
    if (!GetExactWeights(&pattern.Vertices[3 * i], weights))
    {
      return "the weights of a vertex are not in [0, 1] or do not sum to 1";
    }
    const bool isInside = weights[0] > 0 && weights[1] > 0 && weights[2] > 0;
    if (i < border.size() ? weights != border[i] : !isInside)
    {
      return "a vertex is not at the position of its index";
    }
    points.push_back({ weights[1], weights[2] });
  }
  return nullptr;
}

/// Checks each triangle and the total area.
const char* FindDefectOfTriangles(
  const std::vector<unsigned int>& triangles, const std::vector<PatternPoint>& points)
{
  std::int64_t area = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const unsigned int* triangle = &triangles[t];
    if (*std::max_element(triangle, triangle + 3) >= points.size())
    {
      return "a triangle has a vertex that does not exist";
    }
    const std::int64_t orientation =
      Orientation(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
    if (orientation <= 0)
    {
      return "a triangle is degenerate or inverted";
    }
    area += orientation;
  }
  return area == WeightScale * WeightScale ? nullptr : "its triangles overlap or leave a gap";
}

/// Checks that each side is used once, and its opposite too unless it is on the border.
const char* FindDefectOfSides(const RefinementPattern& pattern)
{
  const auto sides = SortedSides(pattern.Triangles);
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end())
  {
    return "its triangles overlap or leave a gap";
  }
  const auto border = BorderSides(pattern.Segments);
  for (const PatternSide& segment : border)
  {
    if (!Contains(sides, segment))
    {
      return "a segment of its border is not an edge of any triangle";
    }
  }
  const auto numberOfOpenSides = std::count_if(sides.begin(), sides.end(),
    [&](const PatternSide& side) {
      return !Contains(sides, { side.second, side.first });
    });
  return static_cast<std::size_t>(numberOfOpenSides) == border.size() ? nullptr
                                                                      : "its triangles leave a gap";
}
}

namespace relevo
{
const char* FindDefect(const RefinementPattern& pattern)
{
  const int* segments = pattern.Segments;
  if (segments[0] > MaximumNumberOfSegments || segments[0] < segments[1] ||
    segments[1] < segments[2] || segments[2] < 1)
  {
    return "its numbers of segments are not in descending order or out of range";
  }
  const int numberOfVertices = pattern.GetNumberOfVertices();
  const int numberOfBorderVertices = pattern.GetNumberOfBorderVertices();
  if (numberOfVertices < numberOfBorderVertices || // Euler's formula:
    pattern.GetNumberOfTriangles() != 2 * numberOfVertices - 2 - numberOfBorderVertices)
  {
    return "its numbers of vertices and triangles contradict each other";
  }
  std::vector<PatternPoint> points;
  const char* defect = FindDefectOfVertices(pattern, points);
  if (!defect)
  {
    defect = FindDefectOfTriangles(pattern.Triangles, points);
  }
  return defect ? defect : FindDefectOfSides(pattern);
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/RefinementPatternGenerator.h"

#include "Patterns/PatternMesh.h"
#include "Patterns/PatternVertexOrder.h"

#include <algorithm>
#include <cstdint>

namespace relevo
{
RefinementPattern GeneratePattern(int n1, int n2, int n3)
{
  const int segments[3] = { n1, n2, n3 };
  return MakePattern(segments, n1 == n3 ? MakeRegularMesh(n1) : MakeGradedMesh(segments));
}

RefinementPattern MakePattern(const int segments[3], PatternMesh mesh)
{
  RefinementPattern pattern;
  std::copy(segments, segments + 3, pattern.Segments);
  OrderForCache(mesh, pattern.GetNumberOfBorderVertices());
  pattern.Vertices.reserve(3 * mesh.Vertices.size());
  for (const auto& weights : mesh.Vertices)
  {
    for (const std::int64_t weight : weights)
    {
      pattern.Vertices.push_back(static_cast<float>(weight) / static_cast<float>(WeightScale));
    }
  }
  pattern.Triangles.reserve(3 * mesh.Triangles.size());
  for (const auto& triangle : mesh.Triangles)
  {
    pattern.Triangles.insert(pattern.Triangles.end(), triangle.begin(), triangle.end());
  }
  MakeLines(pattern);
  return pattern;
}
}

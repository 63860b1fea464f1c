// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternBorder.h"

#include "Patterns/PatternPoint.h"

namespace relevo
{
std::vector<PatternWeights> MakeBorderVertices(const int segments[3], std::int64_t scale)
{
  std::vector<PatternWeights> vertices = { { scale, 0, 0 }, { 0, scale, 0 }, { 0, 0, scale } };
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int k = 1; k < segments[edge]; ++k)
    {
      PatternWeights weights = {};
      const std::int64_t far = DivideRounded(k * scale, segments[edge]);
      weights[edge] = scale - far;
      weights[(edge + 1) % 3] = far;
      vertices.push_back(weights);
    }
  }
  return vertices;
}
}

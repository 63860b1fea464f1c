// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/FacePattern.h"

#include "Mathematics/CornerOrder.h"
#include "Mathematics/RefinementMathematics.h"
#include "Patterns/RefinementPattern.h"

#include <cstddef>

namespace relevo
{
#include "glsl/relevoWeights.glsl"

#include "glsl/relevoMorph.glsl"

void FacePattern::GetWeights(int vertex, float weights[3]) const
{
  const float* v = &this->Pattern->Vertices[3 * static_cast<std::size_t>(vertex)];
  const vec3 uvw(v[0], v[1], v[2]);
  const vec3 w = this->MorphTags
    ? morphWeights(uvw, vec3(this->MorphTags[0], this->MorphTags[1], this->MorphTags[2]))
    : permuteWeights(uvw, this->Code);
  weights[0] = w.x;
  weights[1] = w.y;
  weights[2] = w.z;
}

void FacePattern::GetEdgeSegments(int segments[3]) const
{
  // The pattern's edge i is opposite to its corner i + 2, and the sorted edge e to the corner e +
  // 2.
  const auto& order = GetCornerOrder(this->Code);
  for (int e = 0; e < 3; ++e)
  {
    segments[e] = this->Pattern->Segments[(order[(e + 2) % 3] + 1) % 3];
  }
}
}

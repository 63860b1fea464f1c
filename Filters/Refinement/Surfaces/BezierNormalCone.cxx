// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/BezierNormalCone.h"

#include "Surfaces/SurfaceCorners.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
float ComputeBezierNormalCone(
  int degree, const std::function<vec3(int, int, int)>& controlPoint, float axis[3])
{
  // The patch's tangents along two sides are convex combinations of the differences of control
  // points. Its normals are positive combinations of their cross products.
  std::vector<vec3> along;
  std::vector<vec3> across;
  for (int i = 0; i < degree; ++i)
  {
    for (int j = 0; i + j < degree; ++j)
    {
      const int k = degree - 1 - i - j;
      const vec3 from = controlPoint(i + 1, j, k);
      along.push_back(controlPoint(i, j + 1, k) - from);
      across.push_back(controlPoint(i, j, k + 1) - from);
    }
  }
  std::vector<vec3> normals;
  vec3 sum(0.0f);
  for (const vec3& a : along)
  {
    for (const vec3& b : across)
    {
      normals.push_back(unitVector(cross(a, b)));
      sum += normals.back();
    }
  }
  const vec3 mean = unitVector(sum);
  float cosine = dot(mean, mean) > 0.0f ? 1.0f : 0.0f;
  for (const vec3& normal : normals)
  {
    if (dot(normal, normal) > 0.0f)
    {
      cosine = std::min(cosine, dot(normal, mean));
    }
  }
  store(mean, axis);
  // Flat triangles between points of the patch have a slightly larger angle than the patch.
  constexpr float margin = 0.05f;
  return cosine > margin ? std::cos(std::acos(std::min(cosine, 1.0f)) + margin) : 0.0f;
}
}

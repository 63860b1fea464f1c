// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPNPatch.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
vec3 GetPNMiddleNormal(const vec3& edge, const vec3& normalA, const vec3& normalB)
{
  const float squared = dot(edge, edge);
  const float v = squared > 0.0f ? 2.0f * dot(edge, normalA + normalB) / squared : 0.0f;
  return unitVector(normalA + normalB - v * edge);
}

vec3 GetPNCenter(const SurfaceCorners& corners)
{
  vec3 edges(0.0f);
  for (int edge = 0; edge < 3; ++edge)
  {
    edges += corners.edgeVector(edge, 0) + corners.edgeVector(edge, 1);
  }
  edges /= 6.0f;
  const vec3 middle =
    (corners.cornerPoint(0) + corners.cornerPoint(1) + corners.cornerPoint(2)) / 3.0f;
  return edges + 0.5f * (edges - middle);
}

float ComputePNNormalCone(const SurfaceCorners& corners, float axis[3])
{
  // The patch's tangents along two sides are convex combinations of the differences of control
  // points, and its normals positive ones of their products.
  const auto controlPoint = [&corners](int i, int j, int k)
  {
    // Powers of the weights of corners 0, 1, 2.
    if (std::max({ i, j, k }) == 3)
    {
      return corners.cornerPoint(i == 3 ? 0 : (j == 3 ? 1 : 2));
    }
    if (i == 0)
    {
      return corners.edgeVector(1, j == 2 ? 0 : 1);
    }
    if (j == 0)
    {
      return corners.edgeVector(2, i == 2 ? 0 : 1);
    }
    return k == 0 ? corners.edgeVector(0, i == 2 ? 0 : 1) : corners.faceVector(0);
  };
  vec3 along[6];
  vec3 across[6];
  int count = 0;
  for (int i = 0; i <= 2; ++i)
  {
    for (int j = 0; i + j <= 2; ++j)
    {
      const int k = 2 - i - j;
      const vec3 from = controlPoint(i + 1, j, k);
      along[count] = controlPoint(i, j + 1, k) - from;
      across[count] = controlPoint(i, j, k + 1) - from;
      ++count;
    }
  }
  vec3 normals[36];
  vec3 sum(0.0f);
  for (int n = 0; n < 36; ++n)
  {
    normals[n] = unitVector(cross(along[n / 6], across[n % 6]));
    sum += normals[n];
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
  // Flat triangles between points of the patch are turned a little more than the patch.
  constexpr float margin = 0.05f;
  return cosine > margin ? std::cos(std::acos(std::min(cosine, 1.0f)) + margin) : 0.0f;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/PNPatch.h"

#include "Surfaces/BezierNormalCone.h"

#include "relevoCubicPatch.h"
#include "relevoPNTriangle.h"

#include <algorithm>

namespace relevo
{
std::string GetPNTriangleSource()
{
  return std::string(relevoCubicPatch) + relevoPNTriangle;
}

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
  return ComputeBezierNormalCone(3, controlPoint, axis);
}
}

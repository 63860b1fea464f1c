// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/NearestPatchPoint.h"

#include "Mesh/PatchArrays.h"
#include "Splines/WeightScale.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
// A patch relative to the position, for precision near it.
struct PatchAround
{
  PatchAround(const PatchArrays& patches, int number, const dvec3& place)
  {
    const Patch patch = patches.GetPatch(number);
    this->Shape = { 0, patch.Degrees, patch.IsTriangle };
    const WeightScale scale(patch.FirstPoint, patch.FirstPoint + patch.GetNumberOfPoints(),
      [&](vtkIdType i) { return patches.GetPoint(i); });
    for (int i = 0; i < patch.GetNumberOfPoints(); ++i)
    {
      const dvec4 point = patches.GetPoint(patch.FirstPoint + i);
      const float weight = scale.GetWeight(point);
      this->Points.push_back(vec4(vec3(dvec3(point) - place) * weight, weight));
    }
  }

  vec4 patchPoint(int i) const { return this->Points[static_cast<std::size_t>(i)]; }

#include "glsl/relevoPatch.glsl"

  struct Sample
  {
    vec3 Position;
    vec3 ByU;
    vec3 ByV;
  };

  Sample Evaluate(vec2 uv)
  {
    const PatchPoint at = this->patchPointAt(this->Shape, uv);
    const vec3 position = vec3(at.Point) / at.Point.w;
    return { position, (vec3(at.ByU) - position * at.ByU.w) / at.Point.w,
      (vec3(at.ByV) - position * at.ByV.w) / at.Point.w };
  }

  vec2 Clamp(vec2 uv) const
  {
    uv = clamp(uv, vec2(0.0f), vec2(1.0f));
    const float over = this->Shape.IsTriangle ? 0.5f * (uv.x + uv.y - 1.0f) : 0.0f;
    return over > 0.0f ? clamp(uv - over, vec2(0.0f), vec2(1.0f)) : uv;
  }

  vec2 FindNearestSample()
  {
    const int steps = 2 * std::max(this->Shape.Degrees.x, this->Shape.Degrees.y) + 2;
    vec2 nearest(0.0f);
    float least = std::numeric_limits<float>::max();
    for (int j = 0; j <= steps; ++j)
    {
      for (int i = 0; i <= (this->Shape.IsTriangle ? steps - j : steps); ++i)
      {
        const vec2 uv = vec2(i, j) / float(steps);
        const vec3 position = this->GetPosition(uv);
        if (dot(position, position) < least)
        {
          least = dot(position, position);
          nearest = uv;
        }
      }
    }
    return nearest;
  }

  vec3 GetPosition(vec2 uv)
  {
    const vec4 point = this->patchValueAt(this->Shape, uv);
    return vec3(point) / point.w;
  }

  std::vector<vec4> Points;
  PatchShape Shape;
};
}

vec2 FindNearestPatchPoint(const PatchArrays& patches, int patch, const dvec3& place)
{
  PatchAround around(patches, patch, place);
  vec2 uv = around.FindNearestSample();
  constexpr int maximumSteps = 30;
  constexpr float minimumStep = 1e-7f;
  for (int step = 0; step < maximumSteps; ++step)
  {
    const PatchAround::Sample at = around.Evaluate(uv);
    const float a = dot(at.ByU, at.ByU);
    const float b = dot(at.ByU, at.ByV);
    const float c = dot(at.ByV, at.ByV);
    // At a degenerate edge one of the derivatives vanishes.
    const float damping = 1e-6f * (a + c);
    const float determinant = (a + damping) * (c + damping) - b * b;
    if (!(determinant > 0.0f))
    {
      break;
    }
    const vec2 slope(dot(at.Position, at.ByU), dot(at.Position, at.ByV));
    const vec2 next = around.Clamp(uv -
      vec2((c + damping) * slope.x - b * slope.y, (a + damping) * slope.y - b * slope.x) /
        determinant);
    const vec2 moved = abs(next - uv);
    uv = next;
    if (std::max(moved.x, moved.y) < minimumStep)
    {
      break;
    }
  }
  return uv;
}
}

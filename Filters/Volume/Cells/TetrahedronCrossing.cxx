// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/TetrahedronCrossing.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Sine of the angle below which a ray is parallel to a face.
constexpr double Parallel = 1e-14;

struct Plane
{
  dvec3 Point;
  dvec3 Normal;  // normalized, inwards
  double Height; // of the opposite corner, greater than 0

  Plane(const TetrahedronCorners& corners, int opposite)
    : Point(corners[(opposite + 1) % 4])
  {
    const dvec3 a = corners[(opposite + 2) % 4] - this->Point;
    const dvec3 b = corners[(opposite + 3) % 4] - this->Point;
    this->Normal = normalize(cross(a, b));
    this->Height = dot(corners[opposite] - this->Point, this->Normal);
    if (this->Height < 0.0)
    {
      this->Normal = -this->Normal;
      this->Height = -this->Height;
    }
  }
};
}

double ComputeSixfoldVolume(const TetrahedronCorners& corners)
{
  return std::abs(
    dot(corners[1] - corners[0], cross(corners[2] - corners[0], corners[3] - corners[0])));
}

double ComputeSlopes(const TetrahedronCorners& corners, CornerSlopes& slopes)
{
  const double volume = ComputeSixfoldVolume(corners);
  slopes.fill(dvec3(0.0));
  for (int i = 0; i < 4 && volume > 0.0; ++i)
  {
    const Plane plane(corners, i);
    slopes[i] = plane.Normal / plane.Height;
  }
  return volume;
}

bool TetrahedronCrossing::Find(const TetrahedronCorners& corners, const Ray& ray, double margin)
{
  this->Begin = 0.0;
  this->End = ray.Length;
  for (int i = 0; i < 4; ++i)
  {
    const Plane plane(corners, i);
    const double height = dot(ray.Origin - plane.Point, plane.Normal);
    const double slope = dot(ray.Direction, plane.Normal);
    if (std::abs(slope) < Parallel)
    {
      if (height < -margin)
      {
        return false;
      }
    }
    else if (slope > 0.0)
    {
      this->Begin = std::max(this->Begin, -height / slope);
    }
    else
    {
      this->End = std::min(this->End, -height / slope);
    }
    // The weight of a corner is proportional to the height above the opposite face.
    this->FrontWeights[i] = height / plane.Height;
    this->BackWeights[i] = slope / plane.Height;
  }
  if (!(this->Begin < this->End))
  {
    return false;
  }
  const auto getWeights = [](const dvec4& rounded)
  {
    const dvec4 weights = max(rounded, dvec4(0.0));
    return weights / (weights.x + weights.y + weights.z + weights.w);
  };
  const dvec4 base = this->FrontWeights;
  const dvec4 slopes = this->BackWeights;
  this->FrontWeights = getWeights(base + this->Begin * slopes);
  this->BackWeights = getWeights(base + this->End * slopes);
  return true;
}
}

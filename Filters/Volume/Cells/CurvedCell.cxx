// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CurvedCell.h"

#include "Bezier/DeterminantSigns.h"
#include "Cells/FaceCrossing.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr int MaximumSteps = 30;
constexpr double Converged = 1e-13;
// In parameters. A ray in a face is inside of both cells.
constexpr double Inside = 1e-9;
// Newton's method gives up at parameters farther outside.
constexpr double Astray = 10.0;
}

dvec3 CurvedCell::At(const dvec3& parameters) const
{
  CornerWeights weights;
  this->Shape.Weigh(&parameters.x, weights.data());
  dvec3 point(0.0);
  for (int i = 0; i < this->Shape.NumberOfCorners; ++i)
  {
    point += weights[i] * this->Corners[i];
  }
  return point;
}

dmat3 CurvedCell::Derive(const dvec3& parameters) const
{
  const int count = this->Shape.NumberOfCorners;
  std::array<double, 3 * MaximumCorners> derivatives;
  this->Shape.Derive(&parameters.x, derivatives.data());
  dmat3 result(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < count; ++i)
    {
      result[axis] += derivatives[axis * count + i] * this->Corners[i];
    }
  }
  return result;
}

// The bounds of the corners or, for quadratic cells, of the Bézier points.
void CurvedCell::FindBounds(dvec3& low, dvec3& high) const
{
  low = high = this->Corners[0];
  const auto add = [&](const dvec3& point)
  {
    low = min(low, point);
    high = max(high, point);
  };
  for (int i = 1; i < this->Shape.NumberOfCorners; ++i)
  {
    add(this->Corners[i]);
  }
  for (const auto& face : this->Shape.QuadraticFaces)
  {
    for (int i = 0; i < 3; ++i)
    {
      add(2.0 * this->Corners[face[3 + i]] -
        0.5 * (this->Corners[face[i]] + this->Corners[face[(i + 1) % 3]]));
    }
  }
}

double CurvedCell::ComputeVolume() const
{
  double largest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    const dvec3 corner = dvec3(i & 1, i >> 1 & 1, i >> 2 & 1);
    const dvec3 at = i == 8 ? this->Shape.Center : mix(this->Shape.Center, corner, 0.5);
    largest = std::max(largest, std::abs(determinant(this->Derive(at))));
  }
  return largest;
}

bool CurvedCell::IsFolded() const
{
  double low = 0.0;
  double high = 0.0;
  const auto add = [&](const dvec3& parameters)
  {
    const double volume = determinant(this->Derive(parameters));
    low = std::min(low, volume);
    high = std::max(high, volume);
  };
  const std::array<dvec3, 4> corners = { { dvec3(0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0),
    dvec3(0.0, 0.0, 1.0) } };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      add(0.5 * (corners[i] + corners[j]));
    }
  }
  add(this->Shape.Center);
  return HasBothSigns(low, high);
}

// Inverts the shape functions with Newton's method.
bool CurvedCell::Locate(const dvec3& point, dvec3& parameters) const
{
  for (int i = 0; i < MaximumSteps; ++i)
  {
    const dmat3 derivatives = this->Derive(parameters);
    const double volume = determinant(derivatives);
    if (volume == 0.0 || !(this->Shape.GetOutside(parameters) < Astray))
    {
      return false;
    }
    const dvec3 step = inverse(derivatives) * (point - this->At(parameters));
    parameters += step;
    if (dot(step, step) < Converged * Converged)
    {
      return true;
    }
  }
  // Newton's method can stall because of rounding errors.
  const dvec3 miss = point - this->At(parameters);
  const dvec3 size = this->Corners[1] - this->Corners[0];
  return dot(miss, miss) <= 1e-20 * dot(size, size);
}

// Starts Newton's method at the centre. It can diverge in strongly distorted cells, so that other
// starting points follow.
bool CurvedCell::IsInside(const dvec3& point) const
{
  dvec3 low;
  dvec3 high;
  this->FindBounds(low, high);
  const dvec3 margin = Inside * (high - low);
  if (any(lessThan(point, low - margin)) || any(greaterThan(point, high + margin)))
  {
    return false;
  }
  for (int i = 0; i < 9; ++i)
  {
    const dvec3 corner = dvec3(i & 1, i >> 1 & 1, i >> 2 & 1);
    dvec3 parameters = mix(this->Shape.Center, corner, i == 0 ? 0.0 : 0.6);
    if (this->Locate(point, parameters) && this->Shape.GetOutside(parameters) <= Inside)
    {
      return true;
    }
  }
  return false;
}

CornerWeights CurvedCell::GetWeights(const dvec3& point, dvec3& parameters) const
{
  if (!this->Locate(point, parameters))
  {
    parameters = this->Shape.Center;
    this->Locate(point, parameters);
  }
  // Parameters are unreliable near singular points, such as the top of a pyramid.
  parameters = clamp(parameters, dvec3(0.0), dvec3(1.0));
  CornerWeights weights = {};
  this->Shape.Weigh(&parameters.x, weights.data());
  return weights;
}

double CurvedCell::ComputeSlopes(const dvec3& parameters, CornerSlopes& slopes) const
{
  const int count = this->Shape.NumberOfCorners;
  const dmat3 derivatives = this->Derive(parameters);
  const double volume = std::abs(determinant(derivatives));
  slopes.fill(dvec3(0.0));
  if (volume == 0.0)
  {
    return volume;
  }
  const dmat3 toPlaces = transpose(inverse(derivatives));
  std::array<double, 3 * MaximumCorners> by;
  this->Shape.Derive(&parameters.x, by.data());
  for (int i = 0; i < count; ++i)
  {
    slopes[i] = toPlaces * dvec3(by[i], by[count + i], by[2 * count + i]);
    if (!std::isfinite(dot(slopes[i], slopes[i])))
    {
      slopes.fill(dvec3(0.0));
      return 0.0;
    }
  }
  return volume;
}

// Between two consecutive hits a ray is either inside or outside.
std::vector<std::pair<double, double>> CurvedCell::FindInside(const Ray& ray, double shortest) const
{
  std::vector<double> hits = { 0.0, ray.Length };
  for (const auto& face : this->Shape.Faces)
  {
    CrossBilinearFace({ { this->Corners[face[0]], this->Corners[face[1]], this->Corners[face[2]],
                        this->Corners[face[3]] } },
      ray, hits);
  }
  for (const auto& face : this->Shape.QuadraticFaces)
  {
    std::array<dvec3, 6> points;
    for (int i = 0; i < 6; ++i)
    {
      points[i] = this->Corners[face[i]];
    }
    CrossQuadraticFace(points, ray, hits);
  }
  std::sort(hits.begin(), hits.end());
  std::vector<std::pair<double, double>> inside;
  double begin = 0.0;
  for (const double hit : hits)
  {
    const double end = std::min(hit, ray.Length);
    if (end - begin > shortest)
    {
      if (this->IsInside(ray.Origin + 0.5 * (begin + end) * ray.Direction))
      {
        inside.emplace_back(begin, end);
      }
      begin = end;
    }
  }
  return inside;
}
}

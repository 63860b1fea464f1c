// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/BezierCrossing.h"

#include "Bezier/BezierFaceCrossing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace relevo
{
namespace
{
constexpr int MaximumSteps = 30;
constexpr double Converged = 1e-13;
// In parameters. A ray in a face is inside of both hexahedra.
constexpr double Inside = 1e-9;
// Newton's method gives up at parameters farther outside.
constexpr double Astray = 2.0;

double GetOutside(const dvec3& p)
{
  const dvec3 outside = max(-p, p - 1.0);
  return std::max({ outside.x, outside.y, outside.z });
}
}

BezierCrossing::BezierCrossing(const BezierHexahedron& shape)
  : Shape(shape)
{
  shape.FindBounds(this->Low, this->High);
  for (int i = 0; i < BezierHexahedron::NumberOfSamples; ++i)
  {
    this->Samples[i] = shape.GetPosition(BezierHexahedron::GetSample(i));
  }
}

// Returns whether Newton's method converges.
bool BezierCrossing::Solve(const dvec3& point, dvec3& parameters) const
{
  const double size = length(this->High - this->Low);
  for (int i = 0; i < MaximumSteps; ++i)
  {
    dvec3 position;
    dmat3 derivatives;
    this->Shape.Derive(parameters, position, derivatives);
    const dvec3 miss = point - position;
    if (determinant(derivatives) == 0.0)
    {
      return length(miss) <= Converged * size;
    }
    const dvec3 step = inverse(derivatives) * miss;
    parameters += step;
    if (!(GetOutside(parameters) < Astray))
    {
      return false;
    }
    if (dot(step, step) < Converged * Converged || length(miss) < 1e-3 * Converged * size)
    {
      return true;
    }
  }
  // Newton's method can stall because of rounding errors.
  return distance(point, this->Shape.GetPosition(parameters)) <= 1e-10 * size;
}

// Begins at the nearest samples, because Newton's method can diverge in distorted cells.
bool BezierCrossing::FindAnywhere(const dvec3& point, dvec3& parameters) const
{
  std::array<int, BezierHexahedron::NumberOfSamples> order;
  std::iota(order.begin(), order.end(), 0);
  const auto getDistance = [&](int i)
  {
    const dvec3 way = this->Samples[i] - point;
    return dot(way, way);
  };
  constexpr int attempts = 9;
  std::partial_sort(order.begin(), order.begin() + attempts, order.end(),
    [&](int a, int b) { return getDistance(a) < getDistance(b); });
  for (int i = 0; i < attempts; ++i)
  {
    parameters = BezierHexahedron::GetSample(order[i]);
    if (this->Solve(point, parameters) && GetOutside(parameters) <= Inside)
    {
      return true;
    }
  }
  parameters = BezierHexahedron::GetSample(order[0]);
  return false;
}

bool BezierCrossing::Locate(const dvec3& point, dvec3& parameters) const
{
  const bool isFound = (this->Solve(point, parameters) && GetOutside(parameters) <= 1e3 * Inside) ||
    this->FindAnywhere(point, parameters);
  parameters = clamp(parameters, dvec3(0.0), dvec3(1.0));
  return isFound;
}

// Between two consecutive hits a ray is either inside or outside.
std::vector<std::pair<double, double>> BezierCrossing::FindInside(
  const Ray& ray, double shortest) const
{
  std::vector<double> hits = { 0.0, ray.Length };
  for (int face = 0; face < 6; ++face)
  {
    CrossBezierFace(this->Shape, face, ray, hits);
  }
  std::sort(hits.begin(), hits.end());
  const dvec3 margin = Inside * (this->High - this->Low);
  std::vector<std::pair<double, double>> inside;
  double begin = 0.0;
  for (const double hit : hits)
  {
    const double end = std::min(hit, ray.Length);
    if (end - begin > shortest)
    {
      const dvec3 point = ray.Origin + 0.5 * (begin + end) * ray.Direction;
      const bool isNear = all(greaterThanEqual(point, this->Low - margin)) &&
        all(lessThanEqual(point, this->High + margin));
      dvec3 parameters;
      if (isNear && this->FindAnywhere(point, parameters))
      {
        inside.emplace_back(begin, end);
      }
      begin = end;
    }
  }
  return inside;
}
}

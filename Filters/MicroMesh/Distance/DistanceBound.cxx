// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Distance/DistanceBound.h"

#include <algorithm>
#include <limits>

namespace relevo
{
namespace
{
// Sides of triangles that are not bisected any more, relative to the tolerance.
constexpr double ShortestSide = 1.0 / 16.0;
constexpr double Unbounded = std::numeric_limits<double>::infinity();
}

DistanceBound::Corner DistanceBound::FindCorner(const dvec3& point, int guess) const
{
  double distance2 = this->Tolerance2;
  int nearest = -1;
  if (guess >= 0)
  {
    const double guessed = this->Surface.GetDistance2(point, guess);
    if (guessed <= distance2)
    {
      distance2 = guessed;
      nearest = guess;
    }
  }
  this->Surface.FindNearest(point, distance2, nearest);
  return { point, nearest };
}

double DistanceBound::GetFarthest2(
  int triangle, const Corner& a, const Corner& b, const Corner& c) const
{
  return std::max({ this->Surface.GetDistance2(a.Point, triangle),
    this->Surface.GetDistance2(b.Point, triangle), this->Surface.GetDistance2(c.Point, triangle) });
}

double DistanceBound::GetBound2(const Corner& a, const Corner& b, const Corner& c) const
{
  if (a.Nearest < 0 || b.Nearest < 0 || c.Nearest < 0)
  {
    return Unbounded;
  }
  double bound = this->GetFarthest2(a.Nearest, a, b, c);
  if (b.Nearest != a.Nearest)
  {
    bound = std::min(bound, this->GetFarthest2(b.Nearest, a, b, c));
  }
  if (c.Nearest != a.Nearest && c.Nearest != b.Nearest)
  {
    bound = std::min(bound, this->GetFarthest2(c.Nearest, a, b, c));
  }
  if (bound <= this->Tolerance2)
  {
    return bound;
  }
  const Corner* corners[3] = { &a, &b, &c };
  double longest = -1.0;
  int edge = 0;
  for (int e = 0; e < 3; ++e)
  {
    const dvec3 side = corners[(e + 1) % 3]->Point - corners[e]->Point;
    if (dot(side, side) > longest)
    {
      longest = dot(side, side);
      edge = e;
    }
  }
  if (!(longest > ShortestSide * ShortestSide * this->Tolerance2))
  {
    return Unbounded;
  }
  const Corner& first = *corners[edge];
  const Corner& second = *corners[(edge + 1) % 3];
  const Corner& apex = *corners[(edge + 2) % 3];
  const Corner middle = this->FindCorner(0.5 * (first.Point + second.Point), first.Nearest);
  const double one = this->GetBound2(first, middle, apex);
  return one == Unbounded ? one : std::max(one, this->GetBound2(middle, second, apex));
}
}

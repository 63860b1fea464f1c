// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternSmoother.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace
{
using namespace relevo;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Some patterns would take 120 sweeps, but their smallest angle does not grow further.
constexpr int MaximumNumberOfSweeps = 24;

/// Stars whose smallest angle is at least 38 degrees are not moved: sqrt(3) times the cotangent. A
/// higher value takes longer and does not increase the smallest angle of any pattern.
constexpr double GoodBadness = 1.2799 * 1.7320508075688772;

/// To the six nearest points of a triangular grid.
constexpr PatternPoint Directions[] = { { 1, 0 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { 0, -1 },
  { 1, -1 } };
}

namespace relevo
{
PatternSmoother::PatternSmoother(PatternTriangulation& mesh, int firstInner)
  : Mesh(mesh)
  , FirstInner(firstInner)
{
}

void PatternSmoother::Move()
{
  const int numberOfPoints = static_cast<int>(this->Mesh.Points.size());
  for (int sweep = 0; sweep < MaximumNumberOfSweeps; ++sweep)
  {
    bool moved = false;
    for (int v = this->FirstInner; v < numberOfPoints; ++v)
    {
      moved |= this->MoveVertex(v);
    }
    if (!moved)
    {
      return;
    }
    this->Mesh.MakeDelaunay();
  }
}

std::vector<bool> PatternSmoother::FindSuperfluousPoints()
{
  const int numberOfPoints = static_cast<int>(this->Mesh.Points.size());
  std::vector<bool> superfluous(numberOfPoints, false);
  for (int v = this->FirstInner; v < numberOfPoints; ++v)
  {
    this->Mesh.GetStar(v, this->Star);
    superfluous[v] = this->IsSuperfluous(v) &&
      std::none_of(this->Star.begin(), this->Star.end(),
        [&](const std::pair<int, int>& side) { return superfluous[side.first]; });
  }
  return superfluous;
}

/// The largest badness of the triangles between p and the sides of the star, or any value of at
/// least the limit.
double PatternSmoother::StarBadness(PatternPoint p, double limit) const
{
  double badness = 0.0;
  for (const auto& [a, b] : this->Star)
  {
    badness = std::max(badness, Badness(p, this->Mesh.Points[a], this->Mesh.Points[b]));
    if (badness >= limit)
    {
      break;
    }
  }
  return badness;
}

/// Whether the star's triangles can be replaced by better ones that meet at one of its corners.
bool PatternSmoother::IsSuperfluous(int vertex) const
{
  const double limit = this->StarBadness(this->Mesh.Points[vertex], Infinity);
  if (limit <= GoodBadness)
  {
    return false;
  }
  for (const auto& pair : this->Star)
  {
    const int corner = pair.first;
    double badness = 0.0;
    for (const auto& [a, b] : this->Star)
    {
      if (a != corner && b != corner && badness < limit)
      {
        badness = std::max(
          badness, Badness(this->Mesh.Points[corner], this->Mesh.Points[a], this->Mesh.Points[b]));
      }
    }
    if (badness < limit)
    {
      return true;
    }
  }
  return false;
}

/// Try the centre of the star's corners, then decreasing steps. Returns whether one was better.
bool PatternSmoother::MoveVertex(int vertex)
{
  this->Mesh.GetStar(vertex, this->Star);
  PatternPoint& position = this->Mesh.Points[vertex];
  double best = this->StarBadness(position, Infinity);
  if (best <= GoodBadness)
  {
    return false;
  }
  bool moved = false;
  auto attempt = [&](PatternPoint p)
  {
    const double badness = this->StarBadness(p, best);
    if (badness < best)
    {
      best = badness;
      position = p;
      moved = true;
    }
  };

  std::int64_t shortest = std::numeric_limits<std::int64_t>::max();
  PatternPoint sum;
  for (const auto& pair : this->Star)
  {
    const PatternPoint& p = this->Mesh.Points[pair.first];
    shortest = std::min(shortest, SquaredLength(p - position));
    sum.V += p.V;
    sum.W += p.W;
  }
  const std::int64_t divisor = static_cast<std::int64_t>(this->Star.size()) * InnerStep;
  attempt({ DivideRounded(sum.V, divisor) * InnerStep, DivideRounded(sum.W, divisor) * InnerStep });

  // The first step is between 1/8 and 1/4 of the distance to the nearest corner. Shorter first
  // steps end at worse positions.
  std::int64_t step = InnerStep;
  while (64 * step * step < shortest)
  {
    step *= 2;
  }
  for (; step >= InnerStep; step /= 2)
  {
    const PatternPoint center = position;
    for (const PatternPoint& direction : Directions)
    {
      attempt({ center.V + step * direction.V, center.W + step * direction.W });
    }
  }
  return moved;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceStreamline.h"

#include <algorithm>
#include <cmath>

namespace
{
// Relative to the longest vector. Shorter vectors have no direction.
constexpr double ShortestVector = 1e-8;
// Sine of the angle to an edge below which a vector is parallel to it.
constexpr double EdgeTolerance = 1e-5;
// A position is at a corner if the other weights are smaller than this.
constexpr double CornerTolerance = 1e-10;
// Fraction of a step below which a piece counts as idle.
constexpr double MinimumProgress = 1e-10;
// Limits of the pieces of a step and of consecutive idle pieces. Lines that reach them end.
constexpr int MaximumPieces = 1000;
constexpr int MaximumIdlePieces = 32;
// Fraction of an edge to slide before the triangles are evaluated again.
constexpr double SlideShare = 0.125;
constexpr int MaximumHalvings = 8;

relevo::SurfaceStreamline::Weights MakeCornerWeights(int corner)
{
  relevo::SurfaceStreamline::Weights weights{};
  weights[corner] = 1.0;
  return weights;
}

int FindCornerOf(const relevo::SurfaceTriangles::Triangle& triangle, vtkIdType mergedPoint)
{
  return static_cast<int>(
    std::find(triangle.begin(), triangle.end(), mergedPoint) - triangle.begin());
}
}

namespace relevo
{
void SurfaceStreamline::StartInside(int triangle, const Weights& weights)
{
  this->Triangle = triangle;
  this->CurrentWeights = weights;
  this->StartPoint = this->FindCornerPoint();
}

bool SurfaceStreamline::Advance(double step)
{
  const double least = MinimumProgress * step;
  if (this->StartPoint >= 0)
  {
    if (!this->EnterAt(this->StartPoint, step))
    {
      return false;
    }
    this->StartPoint = -1;
  }
  int idle = 0;
  for (int piece = 0; piece < MaximumPieces && idle < MaximumIdlePieces; ++piece)
  {
    if (step <= least)
    {
      return true;
    }
    const double before = step;
    int corner;
    if (!this->MoveInside(step, corner))
    {
      return false;
    }
    if (step <= least)
    {
      return true;
    }
    if (corner >= 0 && !this->Cross(corner, step))
    {
      return false;
    }
    idle = before - step > least ? 0 : idle + 1;
  }
  return false;
}

SurfaceStreamline::Vector SurfaceStreamline::GetPosition() const
{
  Vector position;
  if (this->StartPoint < 0)
  {
    return this->Vectors->GetPosition(this->Triangle, this->CurrentWeights);
  }
  this->Vectors->GetTriangles().GetPoint(this->StartPoint, position.data());
  return position;
}

bool SurfaceStreamline::FindVelocity(int triangle, const Weights& weights, Weights& rates) const
{
  rates = this->Vectors->GetRates(triangle, weights);
  const double length = this->Vectors->GetLength(triangle, rates);
  if (!(length > ShortestVector))
  {
    return false;
  }
  for (double& rate : rates)
  {
    rate *= this->Normalized ? this->Direction / length : this->Direction;
  }
  // A vector that is parallel to an edge except for rounding must stay on it, because it would
  // leave the surface at a border.
  for (int corner = 0; corner < 3; ++corner)
  {
    if (weights[corner] == 0.0 && rates[corner] < 0.0 &&
      -rates[corner] * this->Vectors->GetHeight(triangle, corner) <
        EdgeTolerance * (this->Normalized ? 1.0 : length))
    {
      rates =
        this->GetRatesAlongEdge(triangle, corner, this->GetSpeedAlongEdge(triangle, corner, rates));
      break;
    }
  }
  return true;
}

// Returns the speed along the edge opposite to a corner, from its first end to its second.
double SurfaceStreamline::GetSpeedAlongEdge(int triangle, int corner, const Weights& rates) const
{
  return rates[(corner + 2) % 3] + rates[corner] * this->Vectors->GetFoot(triangle, corner);
}

SurfaceStreamline::Weights SurfaceStreamline::GetRatesAlongEdge(
  int triangle, int corner, double speed) const
{
  Weights rates{};
  rates[(corner + 1) % 3] = -1.0;
  rates[(corner + 2) % 3] = 1.0;
  if (this->Normalized)
  {
    speed = std::copysign(1.0 / this->Vectors->GetLength(triangle, rates), speed);
  }
  for (double& rate : rates)
  {
    rate *= speed;
  }
  return rates;
}

SurfaceStreamline::Exit SurfaceStreamline::FindExit(const Weights& rates) const
{
  Exit exit{ HUGE_VAL, 0 };
  for (int corner = 0; corner < 3; ++corner)
  {
    const double step =
      rates[corner] < 0.0 ? this->CurrentWeights[corner] / -rates[corner] : HUGE_VAL;
    if (step < exit.Step)
    {
      exit = { step, corner };
    }
  }
  return exit;
}

// Returns the part of the step that is done.
double SurfaceStreamline::Move(const Weights& rates, double step, const Exit& exit)
{
  const bool leaves = exit.Step <= step;
  const double done = leaves ? exit.Step : step;
  double sum = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    double& weight = this->CurrentWeights[corner];
    weight = leaves && corner == exit.Corner ? 0.0 : std::max(weight + done * rates[corner], 0.0);
    sum += weight;
  }
  for (double& weight : this->CurrentWeights)
  {
    weight /= sum;
  }
  return done;
}

// Moves by one piece, at most to the edge that a straight line reaches. `corner` returns the corner
// opposite to that edge, or -1 inside of the triangle.
bool SurfaceStreamline::MoveInside(double& step, int& corner)
{
  Weights rates;
  if (!this->FindVelocity(this->Triangle, this->CurrentWeights, rates))
  {
    return false;
  }
  Exit exit = this->FindExit(rates);
  double piece = std::min(step, exit.Step);
  if (piece > 0.0)
  {
    Weights velocity;
    for (int tries = 0;; ++tries)
    {
      Weights middle;
      for (int i = 0; i < 3; ++i)
      {
        middle[i] = std::max(this->CurrentWeights[i] + 0.5 * piece * rates[i], 0.0);
      }
      if (!this->FindVelocity(this->Triangle, middle, velocity))
      {
        return false;
      }
      exit = this->FindExit(velocity);
      if (exit.Step > 0.0)
      {
        break;
      }
      // The line bends back to the edge that it starts from. Try a shorter piece.
      if (tries == MaximumHalvings)
      {
        corner = exit.Corner;
        this->CurrentWeights[corner] = 0.0;
        this->Slide(this->GetRatesAlongEdge(this->Triangle, corner,
                      this->GetSpeedAlongEdge(this->Triangle, corner, velocity)),
          step);
        return true;
      }
      piece *= 0.5;
    }
    step -= this->Move(velocity, piece, exit);
  }
  corner = exit.Step <= piece ? exit.Corner : -1;
  return true;
}

bool SurfaceStreamline::Cross(int corner, double& step)
{
  const vtkIdType mergedPoint = this->FindCornerPoint();
  if (mergedPoint >= 0)
  {
    return this->EnterAt(mergedPoint, step);
  }
  const int next = this->Vectors->GetNeighbor(this->Triangle, corner);
  Weights rates;
  if (next < 0)
  {
    // A line that is parallel to the border stays on it.
    return this->FindVelocity(this->Triangle, this->CurrentWeights, rates) && rates[corner] >= 0.0;
  }
  int third;
  const Weights weights =
    this->Vectors->GetNeighborWeights(this->Triangle, corner, this->CurrentWeights, third);
  if (!this->FindVelocity(next, weights, rates))
  {
    return false;
  }
  if (rates[third] > 0.0)
  {
    this->Triangle = next;
    this->CurrentWeights = weights;
    return true;
  }
  if (this->FindSlide(this->Triangle, this->CurrentWeights, corner, rates))
  {
    this->Slide(rates, step);
  }
  return true;
}

// Finds the velocity along the edge opposite to a corner if the vectors of both triangles point to
// it: the weighted mean of both that has no component across the edge.
bool SurfaceStreamline::FindSlide(
  int triangle, const Weights& weights, int corner, Weights& rates) const
{
  const int next = this->Vectors->GetNeighbor(triangle, corner);
  Weights mine;
  Weights others;
  int third = 0;
  if (next < 0 || !this->FindVelocity(triangle, weights, mine) || mine[corner] > 0.0 ||
    !this->FindVelocity(
      next, this->Vectors->GetNeighborWeights(triangle, corner, weights, third), others) ||
    others[third] > 0.0)
  {
    return false;
  }
  const double outOfMine = -mine[corner] * this->Vectors->GetHeight(triangle, corner);
  const double outOfOther = -others[third] * this->Vectors->GetHeight(next, third);
  const double sum = outOfMine + outOfOther;
  const double share = sum > 0.0 ? outOfOther / sum : 0.5;
  // The edge can have the opposite direction in the other triangle.
  const auto& corners = this->Vectors->GetTriangles().GetTriangles();
  const bool reverse = corners[triangle][(corner + 1) % 3] != corners[next][(third + 1) % 3];
  const double other = this->GetSpeedAlongEdge(next, third, others);
  const double speed = share * this->GetSpeedAlongEdge(triangle, corner, mine) +
    (1.0 - share) * (reverse ? -other : other);
  Weights unit{};
  unit[(corner + 1) % 3] = -1.0;
  unit[(corner + 2) % 3] = 1.0;
  if (!(std::abs(speed) * this->Vectors->GetLength(triangle, unit) > ShortestVector))
  {
    return false;
  }
  rates = this->GetRatesAlongEdge(triangle, corner, speed);
  return true;
}

void SurfaceStreamline::Slide(const Weights& rates, double& step)
{
  const Exit exit = this->FindExit(rates);
  const double fastest = std::max({ rates[0], rates[1], rates[2] });
  step -= this->Move(rates, std::min(step, SlideShare / fastest), exit);
}

bool SurfaceStreamline::EnterAt(vtkIdType mergedPoint, double& step)
{
  const SurfaceTriangles& surface = this->Vectors->GetTriangles();
  int entered = -1;
  int alongTriangle = -1;
  Weights along{};
  surface.ForEachTriangleIndex(mergedPoint,
    [&](vtkIdType index)
    {
      const int triangle = static_cast<int>(index);
      if (entered >= 0 || this->Vectors->IsBlocked(triangle))
      {
        return;
      }
      const int corner = FindCornerOf(surface.GetTriangles()[index], mergedPoint);
      const Weights weights = MakeCornerWeights(corner);
      Weights rates;
      if (!this->FindVelocity(triangle, weights, rates))
      {
        return;
      }
      const int second = (corner + 1) % 3;
      const int third = (corner + 2) % 3;
      if (rates[second] >= 0.0 && rates[third] >= 0.0)
      {
        entered = triangle;
        return;
      }
      for (int opposite : { second, third })
      {
        if (alongTriangle < 0 && this->FindSlide(triangle, weights, opposite, rates) &&
          rates[corner] < 0.0)
        {
          alongTriangle = triangle;
          along = rates;
        }
      }
    });
  if (entered < 0 && alongTriangle < 0)
  {
    return false;
  }
  this->Triangle = entered >= 0 ? entered : alongTriangle;
  this->CurrentWeights =
    MakeCornerWeights(FindCornerOf(surface.GetTriangles()[this->Triangle], mergedPoint));
  if (entered < 0)
  {
    this->Slide(along, step);
  }
  return true;
}

// Returns the merged point at the current position, or -1.
vtkIdType SurfaceStreamline::FindCornerPoint() const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    if (this->CurrentWeights[(corner + 1) % 3] <= CornerTolerance &&
      this->CurrentWeights[(corner + 2) % 3] <= CornerTolerance)
    {
      return this->Vectors->GetTriangles().GetTriangles()[this->Triangle][corner];
    }
  }
  return -1;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CurvedScalars.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// One halving is not sufficient: scalars with an extremum can match the line at the middle.
constexpr int MinimumSplit = 2;
constexpr int DeepestEdgeSplit = 10;
}

CurvedScalars::CurvedScalars(
  std::function<Scalars(double)> get, const std::vector<Scalars>& corners)
  : Get(std::move(get))
{
  for (size_t c = 0; c < this->Tolerance.size(); ++c)
  {
    const auto range = std::minmax_element(corners.begin(), corners.end(),
      [c](const Scalars& a, const Scalars& b) { return a[c] < b[c]; });
    const double low = (*range.first)[c];
    const double high = (*range.second)[c];
    const double rounding = 1e-12 * std::max(std::abs(low), std::abs(high));
    this->Tolerance[c] = (high - low) / 8192.0 + rounding;
    this->Rounding[c] = 1e-10 * (high - low) + rounding;
  }
}

void CurvedScalars::Split(double begin, double end, std::vector<RayPart>& parts) const
{
  const Scalars front = this->Get(begin);
  this->Split({ begin, end, front, this->Get(end) }, 0, parts);
}

void CurvedScalars::Split(const RayPart& part, int depth, std::vector<RayPart>& parts) const
{
  const double middle = 0.5 * (part.Begin + part.End);
  const Scalars scalars = this->Get(middle);
  const Scalars linear = Interpolate(part.Front, part.Back, 0.5);
  bool isLinear = depth >= MinimumSplit;
  for (size_t c = 0; c < scalars.size(); ++c)
  {
    isLinear = isLinear && std::abs(scalars[c] - linear[c]) <= this->Tolerance[c];
  }
  if (isLinear || depth == DeepestEdgeSplit)
  {
    this->AddTurns(part, scalars, parts);
    return;
  }
  this->Split({ part.Begin, middle, part.Front, scalars }, depth + 1, parts);
  this->Split({ middle, part.End, scalars, part.Back }, depth + 1, parts);
}

void CurvedScalars::AddTurns(
  const RayPart& part, const Scalars& middle, std::vector<RayPart>& parts) const
{
  std::vector<std::pair<double, Scalars>> ends = { { 0.5 * (part.Begin + part.End), middle },
    { part.End, part.Back } };
  for (size_t c = 0; c < middle.size(); ++c)
  {
    double turn;
    if (this->FindTurn(part, middle, c, turn))
    {
      ends.emplace_back(turn, this->Get(turn));
    }
  }
  std::sort(ends.begin(), ends.end());
  RayPart next = { part.Begin, part.Begin, part.Front, part.Front };
  for (const auto& end : ends)
  {
    if (end.first > next.End)
    {
      next = { next.End, end.first, next.Back, end.second };
      parts.push_back(next);
    }
  }
}

// Uses the parabola through front, middle and back first, and then one through points near the
// result, because the scalar is not exactly a parabola.
bool CurvedScalars::FindTurn(
  const RayPart& part, const Scalars& middle, size_t component, double& turn) const
{
  const double front = part.Front[component];
  const double back = part.Back[component];
  const double first = 4.0 * middle[component] - 3.0 * front - back; // slopes at front and back
  const double last = 3.0 * back + front - 4.0 * middle[component];
  const double least = this->Rounding[component];
  if (first * last >= 0.0 || std::min(std::abs(first), std::abs(last)) <= least)
  {
    return false;
  }
  const double length = part.End - part.Begin;
  const double step = 1e-3 * length;
  const double guess =
    std::clamp(part.Begin + length * first / (first - last), part.Begin + step, part.End - step);
  const double before = this->Get(guess - step)[component];
  const double after = this->Get(guess + step)[component];
  const double bend = before - 2.0 * this->Get(guess)[component] + after;
  const double steps = bend == 0.0 ? 0.0 : std::clamp(0.5 * (before - after) / bend, -2.0, 2.0);
  turn = std::clamp(guess + steps * step, part.Begin, part.End);
  return true;
}
}

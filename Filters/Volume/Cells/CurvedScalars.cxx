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
// Two halvings, as scalars that turn round may be as if linear at one middle.
constexpr int LeastSplit = 2;
constexpr int DeepestSplit = 10;
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
  bool isLinear = depth >= LeastSplit;
  for (size_t c = 0; c < scalars.size(); ++c)
  {
    isLinear = isLinear && std::abs(scalars[c] - linear[c]) <= this->Tolerance[c];
  }
  const RayPart first = { part.Begin, middle, part.Front, scalars };
  const RayPart second = { middle, part.End, scalars, part.Back };
  if (isLinear || depth == DeepestSplit)
  {
    parts.push_back(first);
    parts.push_back(second);
    return;
  }
  this->Split(first, depth + 1, parts);
  this->Split(second, depth + 1, parts);
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/LinearPieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Relative to an interval. The value at its end is extrapolated from points this far inside, so
// that rounding errors at jumps have no effect.
constexpr double Inset = 1e-9;
// 2^12 pieces between two kinks are sufficient for the steepest curve.
constexpr int DeepestPieceSplit = 12;

double FindLargest(const dvec4& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z), std::abs(v.w) });
}
}

LinearPieces::LinearPieces(const Function& function, std::vector<double> kinks, double tolerance)
{
  std::sort(kinks.begin(), kinks.end());
  kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
  if (kinks.empty())
  {
    return;
  }
  const auto step = [](double x)
  { return 1e-9 * std::abs(x) + std::numeric_limits<double>::min(); };
  const dvec4 below = function(kinks.front() - step(kinks.front()));
  this->Pieces.push_back({ below, below });
  this->Nodes.push_back(kinks.front());
  for (size_t i = 1; i < kinks.size(); ++i)
  {
    const double begin = kinks[i - 1];
    const double end = kinks[i];
    const auto getEnd = [&](double at, double inset)
    { return 2.0 * function(at + inset) - function(at + 2.0 * inset); };
    const double inset = Inset * (end - begin);
    this->Split(function, begin, end, { getEnd(begin, inset), getEnd(end, -inset) }, tolerance, 0);
  }
  const dvec4 above = function(kinks.back() + step(kinks.back()));
  this->Pieces.push_back({ above, above });
}

void LinearPieces::Split(
  const Function& function, double begin, double end, const Ends& ends, double tolerance, int depth)
{
  bool isLinear = true;
  for (int i = 1; i < 8 && isLinear; ++i)
  {
    const double share = i / 8.0;
    const dvec4 linear = ends.First + share * (ends.Last - ends.First);
    isLinear = FindLargest(function(begin + share * (end - begin)) - linear) <= tolerance;
  }
  if (isLinear || depth == DeepestPieceSplit)
  {
    this->Pieces.push_back(ends);
    this->Nodes.push_back(end);
    return;
  }
  const double middle = begin + 0.5 * (end - begin);
  const dvec4 value = function(middle);
  this->Split(function, begin, middle, { ends.First, value }, tolerance, depth + 1);
  this->Split(function, middle, end, { value, ends.Last }, tolerance, depth + 1);
}

size_t LinearPieces::FindPiece(double x) const
{
  return std::lower_bound(this->Nodes.begin(), this->Nodes.end(), x) - this->Nodes.begin();
}

dvec4 LinearPieces::Evaluate(size_t piece, double x) const
{
  const Ends& ends = this->Pieces[piece];
  if (piece == 0 || piece == this->Nodes.size())
  {
    return ends.First;
  }
  const double begin = this->Nodes[piece - 1];
  const double share = std::clamp((x - begin) / (this->Nodes[piece] - begin), 0.0, 1.0);
  return ends.First + share * (ends.Last - ends.First);
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/CurveIntegral.h"

#include "Integral/LinearSegment.h"

#include <algorithm>
#include <limits>

namespace relevo
{
CurveIntegral::CurveIntegral(const TransferFunctions& functions)
{
  const TransferFunctions::Curve& curve = functions.GetCurves().front();
  const LinearPieces& pieces = curve.Pieces;
  const std::vector<double>& nodes = pieces.GetNodes();
  const double infinity = std::numeric_limits<double>::infinity();
  const dvec4 units(1.0, 1.0, 1.0, 1.0 / curve.UnitDistance);
  this->Component = curve.Component;
  for (size_t i = 0; i <= nodes.size(); ++i)
  {
    const bool isInner = i > 0 && i < nodes.size();
    const double begin = i > 0 ? nodes[i - 1] : -infinity;
    const double end = i < nodes.size() ? nodes[i] : infinity;
    const dvec4 first = pieces.Evaluate(i, begin);
    const dvec4 change = isInner ? pieces.Evaluate(i, end) - first : dvec4(0.0);
    const double inverse = isInner ? 1.0 / (end - begin) : 0.0;
    const dvec4 slopes = abs(change) * inverse;
    this->LargestSlope = std::max({ this->LargestSlope, slopes.x, slopes.y, slopes.z, slopes.w });
    this->Pieces.push_back({ begin, end, inverse, units * first, units * change });
  }
}

dvec4 CurveIntegral::Evaluate(const Piece& piece, double scalar) const
{
  if (piece.InverseWidth == 0.0)
  {
    return piece.First;
  }
  const double share = std::clamp((scalar - piece.Begin) * piece.InverseWidth, 0.0, 1.0);
  return max(piece.First + share * piece.Change, dvec4(0.0)); // rounding errors can be negative
}

// At a node, a function has the value of the piece below it. A segment that begins at a node uses
// the piece that it enters.
template <typename Function>
void CurveIntegral::Cut(
  double front, double back, double length, size_t& current, const Function& add) const
{
  const bool rises = back > front;
  while (rises ? front >= this->Pieces[current].End : front > this->Pieces[current].End)
  {
    ++current;
  }
  while (rises ? front < this->Pieces[current].Begin : front <= this->Pieces[current].Begin)
  {
    --current;
  }
  double begin = 0.0;
  double scalar = front;
  while (
    rises ? this->Pieces[current].End < back : this->Pieces[current].Begin > back && back < front)
  {
    const Piece& piece = this->Pieces[current];
    const double node = rises ? piece.End : piece.Begin;
    const double end = std::clamp((node - front) / (back - front), begin, 1.0);
    if (end > begin)
    {
      add(this->Evaluate(piece, scalar), this->Evaluate(piece, node), (end - begin) * length);
    }
    begin = end;
    scalar = node;
    current += rises ? 1 : -1;
  }
  const Piece& piece = this->Pieces[current];
  add(this->Evaluate(piece, scalar), this->Evaluate(piece, back), (1.0 - begin) * length);
}

void CurveIntegral::Composite(double front, double back, double length, State& state) const
{
  this->Cut(front, back, length, state.Piece,
    [&](const dvec4& first, const dvec4& last, double span)
    { state.Seen = frontOverBack(state.Seen, linearSegment(first, last, span)); });
}

void CurveIntegral::Add(double front, double back, double length, State& state) const
{
  this->Cut(front, back, length, state.Piece,
    [&](const dvec4& first, const dvec4& last, double span)
    { state.Seen += linearSegmentSum(first, last, span); });
}
}

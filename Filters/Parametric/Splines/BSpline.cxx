// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Splines/BSpline.h"

#include "Splines/KnotVector.h"

#include <algorithm>

namespace relevo
{
namespace
{
// A B-spline with few points.
struct Spline
{
  int Degree;
  std::vector<double> Knots;
  std::vector<dvec4> Points;
};

// Raises the knot u to multiplicity `degree`, if necessary.
void InsertKnot(Spline& spline, double u)
{
  const int p = spline.Degree;
  std::vector<double>& knots = spline.Knots;
  std::vector<dvec4>& points = spline.Points;
  const auto [first, last] = std::equal_range(knots.begin(), knots.end(), u);
  int multiplicity = static_cast<int>(last - first);
  int span = static_cast<int>(last - knots.begin()) - 1;
  for (; multiplicity < p; ++multiplicity, ++span)
  {
    const std::vector<dvec4> old = points;
    points.insert(points.begin() + (span - multiplicity), old[span - multiplicity]);
    for (int i = span - p + 1; i <= span - multiplicity; ++i)
    {
      const double share = (u - knots[i]) / (knots[i + p] - knots[i]);
      points[i] = share * old[i] + (1.0 - share) * old[i - 1];
    }
    knots.insert(knots.begin() + span + 1, u);
  }
}

// Converts a span, using the part of the B-spline that influences it.
std::vector<dvec4> DecomposeSpan(
  int p, int span, const std::vector<double>& knots, const std::vector<dvec4>& points)
{
  Spline local{ p, { knots.begin() + (span - p), knots.begin() + (span + p + 2) },
    { points.begin() + (span - p), points.begin() + (span + 1) } };
  InsertKnot(local, knots[span]);
  InsertKnot(local, knots[span + 1]);
  const auto end = std::upper_bound(local.Knots.begin(), local.Knots.end(), knots[span]);
  const auto first = local.Points.begin() + (end - local.Knots.begin()) - 1 - p;
  return { first, first + p + 1 };
}
}

std::vector<dvec4> DecomposeIntoBezier(
  int degree, const std::vector<double>& knots, const std::vector<dvec4>& points)
{
  std::vector<dvec4> pieces;
  for (int span : FindSpans(knots, degree))
  {
    std::vector<dvec4> piece = DecomposeSpan(degree, span, knots, points);
    // With a knot of multiplicity degree + 1, the curve may be discontinuous there.
    const bool isJoined = !pieces.empty() && knots[span - degree] < knots[span];
    piece.front() = isJoined ? pieces.back() : piece.front();
    pieces.insert(pieces.end(), piece.begin(), piece.end());
  }
  return pieces;
}
}

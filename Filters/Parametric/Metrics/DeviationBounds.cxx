// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/DeviationBounds.h"

#include "Metrics/TriangleForm.h"
#include "Splines/TriangleIndex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
// Directions around half a turn; those between two of them are positive sums of both, so that the
// form has to hold for each direction and for each two that follow one another.
constexpr int NumberOfDirections = 12;
constexpr int NumberOfDemands = 2 * NumberOfDirections;
using Directions = std::array<dvec3, NumberOfDirections + 1>;
using Demands = std::array<double, NumberOfDemands>;

const Directions& GetDirections()
{
  static const Directions directions = []
  {
    Directions result;
    for (int k = 0; k <= NumberOfDirections; ++k)
    {
      const double angle = std::acos(-1.0) * k / NumberOfDirections;
      result[k] = std::cos(angle) * dvec3(1.0, -1.0, 0.0) / std::sqrt(2.0) +
        std::sin(angle) * dvec3(1.0, 1.0, -2.0) / std::sqrt(6.0);
    }
    return result;
  }();
  return directions;
}

// What a form must have at least, in a direction or along one of its own coordinates.
struct Demand
{
  dvec3 Row;
  double Least;
};

// The form of least sum that meets demands: it meets three of them with equality.
dvec3 FindLeastForm(const std::vector<Demand>& demands, double slack)
{
  dvec3 best(std::numeric_limits<double>::infinity());
  const std::size_t n = demands.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        const dmat3 rows(demands[i].Row, demands[j].Row, demands[k].Row);
        if (!(std::abs(determinant(rows)) > 1e-9))
        {
          continue;
        }
        const dvec3 form =
          dvec3(demands[i].Least, demands[j].Least, demands[k].Least) * inverse(rows);
        if (form.x + form.y + form.z < best.x + best.y + best.z &&
          std::all_of(demands.begin(), demands.end(),
            [&](const Demand& demand) { return dot(demand.Row, form) >= demand.Least - slack; }))
        {
          best = form;
        }
      }
    }
  }
  return best;
}

// A linear program of three unknowns, by the demands that are met least.
dvec3 FitForm(const Demands& demands)
{
  const double largest = *std::max_element(demands.begin(), demands.end());
  if (!(largest > 0.0))
  {
    return dvec3(0.0);
  }
  if (!(largest <= 1e150))
  {
    return dvec3(std::numeric_limits<double>::infinity());
  }
  const Directions& directions = GetDirections();
  const auto getDemand = [&](int i)
  {
    const int k = i / 2;
    return Demand{ directions[k] * directions[k + i % 2], demands[i] / largest };
  };
  constexpr double slack = 1e-9;
  std::vector<Demand> chosen{ { dvec3(1.0, 0.0, 0.0), 0.0 }, { dvec3(0.0, 1.0, 0.0), 0.0 },
    { dvec3(0.0, 0.0, 1.0), 0.0 } };
  for (;;)
  {
    const dvec3 form = FindLeastForm(chosen, slack);
    Demand missed{ dvec3(0.0), 2.0 * slack };
    double most = 2.0 * slack;
    for (int i = 0; i < NumberOfDemands; ++i)
    {
      const Demand demand = getDemand(i);
      const double lack = demand.Least - dot(demand.Row, form);
      if (lack > most)
      {
        most = lack;
        missed = demand;
      }
    }
    if (!(most > 2.0 * slack))
    {
      // A little more than the slack, for directions have a length of 1.
      return largest * (max(form, dvec3(0.0)) + dvec3(4.0 * slack));
    }
    chosen.push_back(missed);
  }
}

double Length(const dvec4& v)
{
  return length(dvec3(v));
}

// What bounds derivatives of a piece: its points moved to an origin amidst them.
struct Piece
{
  explicit Piece(std::vector<dvec4> homogeneous)
    : Points(std::move(homogeneous))
  {
    dvec3 middle(0.0);
    for (const dvec4& point : this->Points)
    {
      middle += dvec3(point) / point.w / static_cast<double>(this->Points.size());
    }
    for (dvec4& point : this->Points)
    {
      point -= dvec4(point.w * middle, 0.0);
      this->Radius = std::max(this->Radius, Length(point) / point.w);
      this->LeastWeight = std::min(this->LeastWeight, point.w);
    }
  }

  std::vector<dvec4> Points;
  double Radius = 0.0;
  double LeastWeight = std::numeric_limits<double>::infinity();
};

// The largest of derivatives' coordinates and weights.
struct Largest
{
  double Vector = 0.0;
  double Weight = 0.0;

  void Add(const dvec4& derivative)
  {
    this->Vector = std::max(this->Vector, Length(derivative));
    this->Weight = std::max(this->Weight, std::abs(derivative.w));
  }
};

double BoundFirst(const Piece& piece, const Largest& d)
{
  return (d.Vector + d.Weight * piece.Radius) / piece.LeastWeight;
}

double BoundSecond(const Piece& piece, const Largest& d, const Largest& e, const Largest& de)
{
  return (de.Vector + d.Weight * BoundFirst(piece, e) + e.Weight * BoundFirst(piece, d) +
           de.Weight * piece.Radius) /
    piece.LeastWeight;
}

// Control points of a triangle's derivatives in directions d and e.
dvec4 GetFirst(const Piece& piece, int degree, int j, int k, const dvec3& d)
{
  const auto at = [&](int dj, int dk)
  { return piece.Points[GetTriangleIndex(degree, j + dj, k + dk)]; };
  return static_cast<double>(degree) * (d.x * at(0, 0) + d.y * at(1, 0) + d.z * at(0, 1));
}

dvec4 GetSecond(const Piece& piece, int degree, int j, int k, const dvec3& d, const dvec3& e)
{
  const auto at = [&](int dj, int dk)
  { return piece.Points[GetTriangleIndex(degree, j + dj, k + dk)]; };
  return static_cast<double>(degree * (degree - 1)) *
    (d.x * e.x * at(0, 0) + d.y * e.y * at(2, 0) + d.z * e.z * at(0, 2) +
      (d.x * e.y + d.y * e.x) * at(1, 0) + (d.x * e.z + d.z * e.x) * at(0, 1) +
      (d.y * e.z + d.z * e.y) * at(1, 1));
}

// What derivatives of a piece demand of a form, `scale` times as long as its own.
void AddDemands(const TriangleForm& form, double scale, Demands& demands)
{
  const int degree = form.GetDegree();
  const Piece piece(form.GetPoints());
  const Directions& directions = GetDirections();
  std::array<Largest, NumberOfDirections + 1> firsts;
  std::array<Largest, NumberOfDemands> seconds;
  for (int k = 0; k < degree; ++k)
  {
    for (int j = 0; j + k < degree; ++j)
    {
      for (int i = 0; i <= NumberOfDirections; ++i)
      {
        firsts[i].Add(scale * GetFirst(piece, degree, j, k, directions[i]));
      }
      for (int i = 0; i < NumberOfDirections && j + k + 1 < degree; ++i)
      {
        const dvec3& d = directions[i];
        seconds[2 * i].Add(scale * scale * GetSecond(piece, degree, j, k, d, d));
        seconds[2 * i + 1].Add(
          scale * scale * GetSecond(piece, degree, j, k, d, directions[i + 1]));
      }
    }
  }
  for (int i = 0; i < NumberOfDirections; ++i)
  {
    double& one = demands[2 * i];
    one = std::max(one, BoundSecond(piece, firsts[i], firsts[i], seconds[2 * i]));
    double& two = demands[2 * i + 1];
    two = std::max(two, BoundSecond(piece, firsts[i], firsts[i + 1], seconds[2 * i + 1]));
  }
}

// Nets of pieces are nearer to what they bound, the more so where weights differ.
int GetNumberOfSplits(const std::vector<dvec4>& points, int degree)
{
  const bool isRational = std::any_of(points.begin(), points.end(),
    [&](const dvec4& point)
    { return std::abs(point.w - points[0].w) > 1e-9 * std::abs(points[0].w); });
  return isRational ? 2 : (degree > 2 ? 1 : 0);
}

void AddPieces(const TriangleForm& form, int splits, double scale, Demands& demands)
{
  if (splits == 0)
  {
    AddDemands(form, scale, demands);
    return;
  }
  const dmat3 corners(1.0);
  const dvec3 middles[3] = { 0.5 * (corners[1] + corners[2]), 0.5 * (corners[0] + corners[2]),
    0.5 * (corners[0] + corners[1]) };
  for (int c = 0; c < 3; ++c)
  {
    dvec3 piece[3] = { middles[0], middles[1], middles[2] };
    std::swap(piece[(c + 1) % 3], piece[(c + 2) % 3]);
    piece[c] = corners[c];
    AddPieces(TriangleForm(form, piece), splits - 1, 2.0 * scale, demands);
  }
  // Its coordinates run backwards, which lengths do not tell.
  AddPieces(TriangleForm(form, middles), splits - 1, 2.0 * scale, demands);
}

double BoundCurve(const std::vector<dvec4>& points)
{
  const Piece piece(points);
  const auto degree = static_cast<double>(points.size() - 1);
  Largest first;
  Largest second;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    first.Add(degree * (piece.Points[i] - piece.Points[i - 1]));
    if (i > 1)
    {
      second.Add(degree * (degree - 1.0) *
        (piece.Points[i] - 2.0 * piece.Points[i - 1] + piece.Points[i - 2]));
    }
  }
  return BoundSecond(piece, first, first, second);
}

// By halves.
double BoundCurvePieces(std::vector<dvec4> points, int splits)
{
  if (splits == 0)
  {
    return BoundCurve(points);
  }
  std::vector<dvec4> half;
  for (std::size_t n = points.size(); n > 0; --n)
  {
    half.push_back(points[0]);
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
      points[i] = 0.5 * (points[i] + points[i + 1]);
    }
  }
  return 4.0 * std::max(BoundCurvePieces(half, splits - 1), BoundCurvePieces(points, splits - 1));
}
}

dvec3 ComputeDeviationForm(const TriangleForm& triangle)
{
  Demands demands{};
  AddPieces(triangle, GetNumberOfSplits(triangle.GetPoints(), triangle.GetDegree()), 1.0, demands);
  return FitForm(demands);
}

double ComputeChordDeviation(const std::vector<dvec4>& curve)
{
  return BoundCurvePieces(curve, GetNumberOfSplits(curve, static_cast<int>(curve.size()) - 1)) /
    8.0;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/ChordDeviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace relevo
{
namespace
{
// A homogeneous polynomial in s and t: coefficient i belongs to s^(degree - i) t^i.
template <typename T>
using CurveForm = std::vector<T>;

template <typename T>
CurveForm<T> Multiply(const CurveForm<T>& a, const CurveForm<double>& b)
{
  CurveForm<T> product(a.size() + b.size() - 1, T(0.0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

// Differentiates by the parameter t, with s = 1 - t.
template <typename T>
CurveForm<T> Differentiate(const CurveForm<T>& a)
{
  const std::size_t degree = a.size() - 1;
  CurveForm<T> derivative(degree);
  for (std::size_t i = 0; i < degree; ++i)
  {
    derivative[i] = static_cast<double>(i + 1) * a[i + 1] - static_cast<double>(degree - i) * a[i];
  }
  return derivative;
}

template <typename T>
CurveForm<T> Subtract(CurveForm<T> a, const CurveForm<T>& b, double factor)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    a[i] -= factor * b[i];
  }
  return a;
}

// A part of the curve, with bounds of |S''| in the parameter of the whole curve.
class Piece
{
public:
  Piece(std::vector<dvec4> points, bool isRational, double scale)
    : Points(std::move(points))
    , IsRational(isRational)
    , Scale(scale)
  {
    if (isRational)
    {
      this->BoundRational();
    }
    else
    {
      this->BoundPolynomial();
    }
  }

  double GetMost() const { return this->Most; }
  /// Returns the larger |S''| of both ends.
  double GetLeast() const { return this->Least; }
  bool operator<(const Piece& other) const { return this->Most < other.Most; }

  std::pair<Piece, Piece> Halve() const
  {
    std::vector<dvec4> rest = this->Points;
    std::vector<dvec4> first;
    for (std::size_t n = rest.size(); n > 0; --n)
    {
      first.push_back(rest[0]);
      for (std::size_t i = 0; i + 1 < n; ++i)
      {
        rest[i] = 0.5 * (rest[i] + rest[i + 1]);
      }
    }
    const double scale = 4.0 * this->Scale;
    return { Piece(std::move(first), this->IsRational, scale),
      Piece(std::move(rest), this->IsRational, scale) };
  }

private:
  void BoundPolynomial()
  {
    const std::size_t degree = this->Points.size() - 1;
    const double factor = static_cast<double>(degree * (degree - 1)) / this->Points[0].w;
    for (std::size_t i = 0; i + 2 <= degree; ++i)
    {
      this->Add(
        factor * length(dvec3(this->Points[i] - 2.0 * this->Points[i + 1] + this->Points[i + 2])),
        i == 0 || i + 2 == degree);
    }
  }

  void BoundRational()
  {
    // Products cannot overflow relative to the first point and with weights of at most 1.
    const dvec3 origin = dvec3(this->Points[0]) / this->Points[0].w;
    double largestWeight = 0.0;
    for (const dvec4& point : this->Points)
    {
      largestWeight = std::max(largestWeight, point.w);
    }
    CurveForm<dvec3> a;
    CurveForm<double> w;
    double binomial = 1.0;
    const std::size_t degree = this->Points.size() - 1;
    for (std::size_t i = 0; i <= degree; ++i)
    {
      const dvec4 point = binomial / largestWeight * this->Points[i];
      a.push_back(dvec3(point) - point.w * origin);
      w.push_back(point.w);
      binomial *= static_cast<double>(degree - i) / static_cast<double>(i + 1);
    }
    const CurveForm<double> slope = Differentiate(w);
    const CurveForm<dvec3> c = Subtract(Multiply(Differentiate(a), w), Multiply(a, slope), 1.0);
    const CurveForm<dvec3> n =
      Multiply(Subtract(Multiply(Differentiate(c), w), Multiply(c, slope), 2.0), { 1.0, 2.0, 1.0 });
    const CurveForm<double> divisor = Multiply(Multiply(w, w), w);
    for (std::size_t i = 0; i < n.size(); ++i)
    {
      this->Add(
        divisor[i] > 0.0 ? length(n[i]) / divisor[i] : std::numeric_limits<double>::infinity(),
        i == 0 || i + 1 == n.size());
    }
  }

  void Add(double ratio, bool isEnd)
  {
    this->Most = std::max(this->Most, this->Scale * ratio);
    if (isEnd)
    {
      this->Least = std::max(this->Least, this->Scale * ratio);
    }
  }

  std::vector<dvec4> Points;
  bool IsRational;
  double Scale;
  double Most = 0.0;
  double Least = 0.0;
};
}

double ComputeChordDeviation(const std::vector<dvec4>& curve)
{
  constexpr int maximumSplits = 32;
  constexpr double tolerance = 1.1; // acceptable, because the number of segments grows with the
                                    // square root
  constexpr double negligible = 1e-9;

  double size = 0.0;
  bool isRational = false;
  for (const dvec4& point : curve)
  {
    size = std::max(size, distance(dvec3(point) / point.w, dvec3(curve[0]) / curve[0].w));
    isRational = isRational || std::abs(point.w - curve[0].w) > 1e-9 * curve[0].w;
  }
  std::priority_queue<Piece> pieces;
  pieces.emplace(curve, isRational, 1.0);
  double least = std::max(pieces.top().GetLeast(), negligible * size);
  for (int split = 0; split < maximumSplits && pieces.top().GetMost() > tolerance * least; ++split)
  {
    std::pair<Piece, Piece> halves = pieces.top().Halve();
    pieces.pop();
    least = std::max(least, std::max(halves.first.GetLeast(), halves.second.GetLeast()));
    pieces.push(std::move(halves.first));
    pieces.push(std::move(halves.second));
  }
  return pieces.top().GetMost() / 8.0;
}
}

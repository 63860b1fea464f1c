// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/SecondDerivatives.h"

#include "Mathematics/TriangleIndex.h"
#include "Metrics/TriangleForm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// A homogeneous polynomial in barycentric coordinates. The coefficient at GetTriangleIndex(Degree,
// j, k) belongs to u^(Degree - j - k) v^j w^k.
template <typename T>
struct Form
{
  explicit Form(int degree)
    : Degree(degree)
    , Coefficients(GetTriangleIndex(degree, 0, degree) + 1, T(0.0))
  {
  }

  T& At(int j, int k) { return this->Coefficients[GetTriangleIndex(this->Degree, j, k)]; }
  const T& At(int j, int k) const
  {
    return this->Coefficients[GetTriangleIndex(this->Degree, j, k)];
  }

  int Degree;
  std::vector<T> Coefficients;
};

template <typename T>
Form<T> Multiply(const Form<T>& a, const Form<double>& b)
{
  Form<T> product(a.Degree + b.Degree);
  for (int k = 0; k <= a.Degree; ++k)
  {
    for (int m = 0; m <= b.Degree; ++m)
    {
      T* row = &product.At(0, k + m);
      const T* ofA = &a.At(0, k);
      const double* ofB = &b.At(0, m);
      for (int j = 0; j <= a.Degree - k; ++j)
      {
        for (int i = 0; i <= b.Degree - m; ++i)
        {
          row[j + i] += ofA[j] * ofB[i];
        }
      }
    }
  }
  return product;
}

// Differentiates by coordinate 1 or 2, while the first coordinate decreases.
template <typename T>
Form<T> Differentiate(const Form<T>& a, int coordinate)
{
  Form<T> derivative(a.Degree - 1);
  for (int k = 0; k < a.Degree; ++k)
  {
    for (int j = 0; j + k < a.Degree; ++j)
    {
      const double exponent = coordinate == 1 ? j + 1 : k + 1;
      const T& raised = coordinate == 1 ? a.At(j + 1, k) : a.At(j, k + 1);
      derivative.At(j, k) = exponent * raised - static_cast<double>(a.Degree - j - k) * a.At(j, k);
    }
  }
  return derivative;
}

template <typename T>
Form<T> Subtract(Form<T> a, const Form<T>& b, double factor)
{
  for (std::size_t i = 0; i < a.Coefficients.size(); ++i)
  {
    a.Coefficients[i] -= factor * b.Coefficients[i];
  }
  return a;
}

double GetFactorial(int n)
{
  double result = 1.0;
  for (int i = 2; i <= n; ++i)
  {
    result *= i;
  }
  return result;
}
}

SecondDerivatives::SecondDerivatives(const TriangleForm& form)
{
  if (form.IsRational())
  {
    this->BuildRational(form);
  }
  else
  {
    this->BuildPolynomial(form);
  }
}

double SecondDerivatives::Bound(const dvec3& d, const dvec3& e) const
{
  if (!this->IsBounded)
  {
    return std::numeric_limits<double>::infinity();
  }
  const dvec3 shares(d.y * e.y, d.y * e.z + d.z * e.y, d.z * e.z);
  double most = 0.0;
  for (std::size_t i = 0; i < this->UU.size(); ++i)
  {
    const dvec3 point = shares.x * this->UU[i] + shares.y * this->UV[i] + shares.z * this->VV[i];
    most = std::max(most, dot(point, point));
  }
  return std::sqrt(most);
}

void SecondDerivatives::BuildPolynomial(const TriangleForm& form)
{
  const int degree = form.GetDegree();
  const std::vector<dvec4>& points = form.GetPoints();
  const double factor = degree * (degree - 1) / points[0].w;
  for (int k = 0; k + 2 <= degree; ++k)
  {
    for (int j = 0; j + k + 2 <= degree; ++j)
    {
      const auto at = [&](int dj, int dk)
      { return factor * dvec3(points[GetTriangleIndex(degree, j + dj, k + dk)]); };
      this->UU.push_back(at(2, 0) - 2.0 * at(1, 0) + at(0, 0));
      this->UV.push_back(at(1, 1) - at(1, 0) - at(0, 1) + at(0, 0));
      this->VV.push_back(at(0, 2) - 2.0 * at(0, 1) + at(0, 0));
    }
  }
}

void SecondDerivatives::BuildRational(const TriangleForm& form)
{
  // Products cannot overflow relative to the first point and with weights of at most 1.
  const int degree = form.GetDegree();
  const std::vector<dvec4>& points = form.GetPoints();
  const dvec3 origin = dvec3(points[0]) / points[0].w;
  double largestWeight = 0.0;
  for (const dvec4& point : points)
  {
    largestWeight = std::max(largestWeight, point.w);
  }
  Form<dvec3> a(degree);
  Form<double> w(degree);
  for (int k = 0; k <= degree; ++k)
  {
    for (int j = 0; j + k <= degree; ++j)
    {
      const double multinomial =
        GetFactorial(degree) / (GetFactorial(j) * GetFactorial(k) * GetFactorial(degree - j - k));
      const dvec4 point = multinomial / largestWeight * points[GetTriangleIndex(degree, j, k)];
      a.At(j, k) = dvec3(point) - point.w * origin;
      w.At(j, k) = point.w;
    }
  }
  Form<double> square(2); // square of the sum of coordinates, which is 1
  square.Coefficients = { 1.0, 2.0, 1.0, 2.0, 2.0, 1.0 };
  const Form<double> divisor = Multiply(Multiply(w, w), w);
  // False only if weights differ so much that their product underflows.
  this->IsBounded = std::all_of(divisor.Coefficients.begin(), divisor.Coefficients.end(),
    [](double value) { return value > 0.0; });
  const Form<double> slopes[2] = { Differentiate(w, 1), Differentiate(w, 2) };
  const auto getFirst = [&](int d)
  { return Subtract(Multiply(Differentiate(a, d + 1), w), Multiply(a, slopes[d]), 1.0); };
  const auto getSecond = [&](const Form<dvec3>& first, int e)
  {
    Form<dvec3> n = Multiply(
      Subtract(Multiply(Differentiate(first, e + 1), w), Multiply(first, slopes[e]), 2.0), square);
    for (std::size_t i = 0; i < n.Coefficients.size(); ++i)
    {
      n.Coefficients[i] /= divisor.Coefficients[i];
    }
    return n.Coefficients;
  };
  const Form<dvec3> ofU = getFirst(0);
  const Form<dvec3> ofV = getFirst(1);
  this->UU = getSecond(ofU, 0);
  this->UV = getSecond(ofU, 1);
  this->VV = getSecond(ofV, 1);
}
}

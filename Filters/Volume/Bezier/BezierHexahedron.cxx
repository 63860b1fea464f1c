// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/BezierHexahedron.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
using Basis = std::array<double, LargestDegree + 1>;

void FindBernstein(int degree, double t, Basis& values)
{
  values[0] = 1.0;
  for (int n = 1; n <= degree; ++n)
  {
    values[n] = t * values[n - 1];
    for (int i = n - 1; i > 0; --i)
    {
      values[i] = (1.0 - t) * values[i] + t * values[i - 1];
    }
    values[0] *= 1.0 - t;
  }
}

// Computes the polynomials and their derivatives.
void FindBernstein(int degree, double t, Basis& values, Basis& slopes)
{
  Basis lower = {};
  FindBernstein(degree - 1, t, lower);
  FindBernstein(degree, t, values);
  for (int i = 0; i <= degree; ++i)
  {
    slopes[i] = degree * ((i > 0 ? lower[i - 1] : 0.0) - (i < degree ? lower[i] : 0.0));
  }
}

dvec3 GetPlace(const double* values)
{
  return dvec3(values[0], values[1], values[2]);
}

// The largest values of a homogeneous polynomial and its derivatives by a parameter.
struct Largest
{
  double Value = 0.0;
  double First = 0.0;
  double Second = 0.0;

  // Bounds the second derivative of the quotient by a weight with a least value.
  double BoundQuotient(const Largest& weight, double least) const
  {
    const double value = this->Value / least;
    const double first = (this->First + value * weight.First) / least;
    return (this->Second + 2.0 * first * weight.First + value * weight.Second) / least;
  }
};
}

BezierHexahedron::BezierHexahedron(const ivec3& degrees, int numberOfScalars)
  : Degrees(degrees)
  , Stride(FirstScalar + numberOfScalars)
  , Coefficients(static_cast<size_t>(this->GetNumberOfCoefficients() * this->Stride))
{
}

int BezierHexahedron::GetNumberOfCoefficients() const
{
  return (this->Degrees.x + 1) * (this->Degrees.y + 1) * (this->Degrees.z + 1);
}

void BezierHexahedron::Move(const dvec3& offset)
{
  for (int i = 0; i < this->GetNumberOfCoefficients(); ++i)
  {
    double* values = this->GetCoefficient(i);
    for (int c = 0; c < 3; ++c)
    {
      values[c] += values[3] * offset[c];
    }
  }
}

std::vector<double> BezierHexahedron::GetBasis(const ivec3& degrees, const dvec3& parameters)
{
  std::array<Basis, 3> basis;
  for (int d = 0; d < 3; ++d)
  {
    FindBernstein(degrees[d], parameters[d], basis[d]);
  }
  std::vector<double> products;
  for (int k = 0; k <= degrees.z; ++k)
  {
    for (int j = 0; j <= degrees.y; ++j)
    {
      for (int i = 0; i <= degrees.x; ++i)
      {
        products.push_back(basis[0][i] * basis[1][j] * basis[2][k]);
      }
    }
  }
  return products;
}

BezierHexahedron::Values BezierHexahedron::Sum(const Basis& u, const Basis& v, const Basis& w) const
{
  Values sum = {};
  const double* values = this->Coefficients.data();
  for (int k = 0; k <= this->Degrees.z; ++k)
  {
    for (int j = 0; j <= this->Degrees.y; ++j)
    {
      Values row = {};
      for (int i = 0; i <= this->Degrees.x; ++i)
      {
        for (int c = 0; c < this->Stride; ++c)
        {
          row[c] += u[i] * *values++;
        }
      }
      const double factor = v[j] * w[k];
      for (int c = 0; c < this->Stride; ++c)
      {
        sum[c] += factor * row[c];
      }
    }
  }
  return sum;
}

// Computes the homogeneous values and their derivatives by the parameters.
void BezierHexahedron::SumAll(const dvec3& parameters, std::array<Values, 4>& sums) const
{
  std::array<Basis, 3> values;
  std::array<Basis, 3> slopes;
  for (int d = 0; d < 3; ++d)
  {
    FindBernstein(this->Degrees[d], parameters[d], values[d], slopes[d]);
  }
  sums = {};
  const double* next = this->Coefficients.data();
  for (int k = 0; k <= this->Degrees.z; ++k)
  {
    for (int j = 0; j <= this->Degrees.y; ++j)
    {
      Values row = {};
      Values slope = {};
      for (int i = 0; i <= this->Degrees.x; ++i)
      {
        for (int c = 0; c < this->Stride; ++c, ++next)
        {
          row[c] += values[0][i] * *next;
          slope[c] += slopes[0][i] * *next;
        }
      }
      const double factor = values[1][j] * values[2][k];
      const double byV = slopes[1][j] * values[2][k];
      const double byW = values[1][j] * slopes[2][k];
      for (int c = 0; c < this->Stride; ++c)
      {
        sums[0][c] += factor * row[c];
        sums[1][c] += factor * slope[c];
        sums[2][c] += byV * row[c];
        sums[3][c] += byW * row[c];
      }
    }
  }
}

BezierPoint BezierHexahedron::Evaluate(const dvec3& parameters) const
{
  std::array<Basis, 3> basis;
  for (int d = 0; d < 3; ++d)
  {
    FindBernstein(this->Degrees[d], parameters[d], basis[d]);
  }
  const Values sum = this->Sum(basis[0], basis[1], basis[2]);
  BezierPoint point = { GetPlace(sum.data()) / sum[3], {} };
  for (int c = 0; c < this->GetNumberOfScalars(); ++c)
  {
    point.Values[c] = sum[FirstScalar + c] / sum[3];
  }
  return point;
}

dvec3 BezierHexahedron::GetPosition(const dvec3& parameters) const
{
  return this->Evaluate(parameters).Position;
}

void BezierHexahedron::Derive(const dvec3& parameters, dvec3& position, dmat3& derivatives) const
{
  std::array<Values, 4> sums;
  this->SumAll(parameters, sums);
  const double weight = sums[0][3];
  position = GetPlace(sums[0].data()) / weight;
  for (int d = 0; d < 3; ++d)
  {
    const double* by = sums[1 + d].data();
    derivatives[d] = (GetPlace(by) - by[3] * position) / weight;
  }
}

dmat3 BezierHexahedron::Derive(const dvec3& parameters) const
{
  dvec3 position;
  dmat3 derivatives;
  this->Derive(parameters, position, derivatives);
  return derivatives;
}

Gradients BezierHexahedron::ComputeGradients(const dvec3& parameters) const
{
  std::array<Values, 4> sums;
  this->SumAll(parameters, sums);
  const double weight = sums[0][3];
  const dvec3 position = GetPlace(sums[0].data()) / weight;
  dmat3 derivatives;
  for (int d = 0; d < 3; ++d)
  {
    const double* by = sums[1 + d].data();
    derivatives[d] = (GetPlace(by) - by[3] * position) / weight;
  }
  Gradients gradients = {};
  if (determinant(derivatives) == 0.0)
  {
    return gradients;
  }
  const dmat3 toPlaces = transpose(inverse(derivatives));
  for (int c = 0; c < this->GetNumberOfScalars(); ++c)
  {
    const int at = FirstScalar + c;
    const double value = sums[0][at] / weight;
    dvec3 slopes;
    for (int d = 0; d < 3; ++d)
    {
      slopes[d] = (sums[1 + d][at] - sums[1 + d][3] * value) / weight;
    }
    const dvec3 gradient = toPlaces * slopes;
    gradients[c] = std::isfinite(dot(gradient, gradient)) ? gradient : dvec3(0.0);
  }
  return gradients;
}

void BezierHexahedron::FindBounds(dvec3& low, dvec3& high) const
{
  low = dvec3(std::numeric_limits<double>::max());
  high = -low;
  for (int i = 0; i < this->GetNumberOfCoefficients(); ++i)
  {
    const double* values = this->GetCoefficient(i);
    const dvec3 place = GetPlace(values) / values[3];
    low = min(low, place);
    high = max(high, place);
  }
}

void BezierHexahedron::FindRange(int component, double& low, double& high) const
{
  low = std::numeric_limits<double>::max();
  high = -low;
  constexpr int steps = 4;
  for (int i = 0; i < steps * steps * steps; ++i)
  {
    const dvec3 at = dvec3(i % steps, i / steps % steps, i / steps / steps) / (steps - 1.0);
    const double value = this->Evaluate(at).Values[component];
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

// The derivatives of a polynomial are bounded by the differences of its Bézier coefficients.
// Positions and scalars are relative to those of the middle, which makes bounds of rational
// hexahedra tighter.
std::array<double, 1 + MaximumComponents> BezierHexahedron::BoundSecondDerivatives(
  int direction) const
{
  const int count = 2 + this->GetNumberOfScalars(); // position, scalars and weight
  std::array<Largest, 2 + MaximumComponents> largest;
  double least = std::numeric_limits<double>::max();
  const BezierPoint middle = this->Evaluate(dvec3(0.5));
  const auto get = [&](int at)
  {
    Values values;
    const double* from = this->GetCoefficient(at);
    std::copy(from, from + this->Stride, values.begin());
    for (int c = 0; c < 3; ++c)
    {
      values[c] -= values[3] * middle.Position[c];
    }
    for (int c = FirstScalar; c < this->Stride; ++c)
    {
      values[c] -= values[3] * middle.Values[c - FirstScalar];
    }
    return values;
  };
  const auto getSize = [&](const Values& values, int i)
  {
    return i == 0     ? length(GetPlace(values.data()))
      : i + 1 < count ? std::abs(values[FirstScalar + i - 1])
                      : std::abs(values[3]);
  };
  const int degree = this->Degrees[direction];
  const int step = direction == 0 ? 1
    : direction == 1              ? this->Degrees.x + 1
                                  : (this->Degrees.x + 1) * (this->Degrees.y + 1);
  for (int at = 0; at < this->GetNumberOfCoefficients(); ++at)
  {
    const int place = at / step % (degree + 1);
    const Values here = get(at);
    const Values next = place < degree ? get(at + step) : here;
    const Values last = place + 1 < degree ? get(at + 2 * step) : next;
    Values first = {};
    Values second = {};
    for (int c = 0; c < this->Stride; ++c)
    {
      first[c] = degree * (next[c] - here[c]);
      second[c] = degree * (degree - 1) * (last[c] - 2.0 * next[c] + here[c]);
    }
    least = std::min(least, here[3]);
    for (int i = 0; i < count; ++i)
    {
      largest[i].Value = std::max(largest[i].Value, getSize(here, i));
      largest[i].First = std::max(largest[i].First, getSize(first, i));
      largest[i].Second =
        place + 1 < degree ? std::max(largest[i].Second, getSize(second, i)) : largest[i].Second;
    }
  }
  std::array<double, 1 + MaximumComponents> bounds = {};
  for (int i = 0; i + 1 < count; ++i)
  {
    bounds[i] = largest[i].BoundQuotient(largest[count - 1], least);
  }
  return bounds;
}

dvec3 BezierHexahedron::GetSample(int i)
{
  return (dvec3(i % 3, i / 3 % 3, i / 9) + 0.5) / 3.0;
}
}

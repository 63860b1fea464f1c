// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mathematics/LagrangeToBezier.h"

#include "Mathematics/BezierDegree.h"
#include "Mathematics/TriangleIndex.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace relevo
{
namespace
{
using Integer = std::int64_t;
using IntegerTable = std::array<std::array<Integer, LargestDegree + 1>, LargestDegree + 1>;

// Binomial coefficients, and signed Stirling numbers of the first kind.
struct Numbers
{
  IntegerTable Binomial{};
  IntegerTable Stirling{};
  std::array<Integer, LargestDegree + 1> Factorial{};

  Numbers()
  {
    this->Factorial[0] = this->Binomial[0][0] = this->Stirling[0][0] = 1;
    for (int n = 1; n <= LargestDegree; ++n)
    {
      this->Factorial[n] = n * this->Factorial[n - 1];
      this->Binomial[n][0] = 1;
      for (int k = 1; k <= n; ++k)
      {
        this->Binomial[n][k] = this->Binomial[n - 1][k - 1] + this->Binomial[n - 1][k];
        this->Stirling[n][k] = this->Stirling[n - 1][k - 1] - (n - 1) * this->Stirling[n - 1][k];
      }
    }
  }
};

Integer Power(Integer base, int exponent)
{
  return exponent == 0 ? 1 : base * Power(base, exponent - 1);
}

// Factors of the forward differences of the nodes, (a, b) times along u and v, in the Bézier
// coefficient (i, j), multiplied by (degree!)^2 to get integers. Newton's polynomials are C(n u, a)
// C(n v, b). The Bézier coefficients of their powers of u and v have a closed form.
IntegerTable GetDifferenceFactors(const Numbers& numbers, int degree, int i, int j)
{
  IntegerTable factors{};
  for (int a = 0; a <= degree; ++a)
  {
    for (int b = 0; a + b <= degree; ++b)
    {
      Integer sum = 0;
      for (int m = 0; m <= std::min(a, i); ++m)
      {
        for (int l = 0; l <= std::min(b, j); ++l)
        {
          sum += numbers.Stirling[a][m] * numbers.Stirling[b][l] * Power(degree, m + l) *
            numbers.Binomial[i][m] * numbers.Binomial[j][l] * numbers.Factorial[m] *
            numbers.Factorial[l] * numbers.Factorial[degree - m - l];
        }
      }
      factors[a][b] =
        sum * (numbers.Factorial[degree] / (numbers.Factorial[a] * numbers.Factorial[b]));
    }
  }
  return factors;
}

// Factor of node (x, y) in a coefficient: a quotient of integers, rounded once.
double GetNodeFactor(
  const Numbers& numbers, int degree, const IntegerTable& differences, int x, int y)
{
  Integer sum = 0;
  for (int a = x; a <= degree; ++a)
  {
    for (int b = y; a + b <= degree; ++b)
    {
      const Integer sign = (a - x + b - y) % 2 == 0 ? 1 : -1;
      sum += sign * numbers.Binomial[a][x] * numbers.Binomial[b][y] * differences[a][b];
    }
  }
  const Integer factorial = numbers.Factorial[degree];
  return static_cast<double>(sum) / static_cast<double>(factorial * factorial);
}

// The row-major matrices for a degree.
struct Matrices
{
  std::vector<double> Curve;
  std::vector<double> Triangle;
};

Matrices ComputeMatrices(int degree)
{
  const Numbers numbers;
  Matrices matrices;
  for (int j = 0; j <= degree; ++j)
  {
    for (int i = 0; i + j <= degree; ++i)
    {
      const IntegerTable differences = GetDifferenceFactors(numbers, degree, i, j);
      for (int y = 0; y <= degree; ++y)
      {
        for (int x = 0; x + y <= degree; ++x)
        {
          matrices.Triangle.push_back(GetNodeFactor(numbers, degree, differences, x, y));
        }
      }
    }
  }
  const int size = (degree + 1) * (degree + 2) / 2;
  for (int i = 0; i <= degree; ++i) // the edge of a triangle only depends on its nodes
  {
    const auto row = matrices.Triangle.begin() + i * size;
    matrices.Curve.insert(matrices.Curve.end(), row, row + degree + 1);
  }
  return matrices;
}

const Matrices& GetMatrices(int degree)
{
  static const std::array<Matrices, LargestDegree + 1> matrices = []
  {
    std::array<Matrices, LargestDegree + 1> all;
    for (int n = 1; n <= LargestDegree; ++n)
    {
      all[n] = ComputeMatrices(n);
    }
    return all;
  }();
  return matrices[degree];
}
}

void ConvertLagrangeToBezier(int degree, int components, double* values, std::ptrdiff_t stride)
{
  if (degree == 1)
  {
    return;
  }
  const double* matrix = GetMatrices(degree).Curve.data();
  std::array<double, LargestDegree + 1> nodes;
  for (int c = 0; c < components; ++c)
  {
    for (int i = 0; i <= degree; ++i)
    {
      nodes[i] = values[i * stride + c];
    }
    for (int k = 1; k < degree; ++k)
    {
      // Added in pairs from both ends, so that the sum does not depend on the direction.
      const double* row = matrix + k * (degree + 1);
      double sum = degree % 2 == 0 ? row[degree / 2] * nodes[degree / 2] : 0.0;
      for (int i = 0; 2 * i < degree; ++i)
      {
        sum += row[i] * nodes[i] + row[degree - i] * nodes[degree - i];
      }
      values[k * stride + c] = sum;
    }
  }
}

void ConvertLagrangeTriangleToBezier(int degree, int components, double* values)
{
  const int size = (degree + 1) * (degree + 2) / 2;
  const std::vector<double> nodes(values, values + size * components);
  const double* row = GetMatrices(degree).Triangle.data();
  for (int k = 0; k < size; ++k, row += size)
  {
    for (int c = 0; c < components; ++c)
    {
      double sum = 0.0;
      for (int i = 0; i < size; ++i)
      {
        sum += row[i] * nodes[i * components + c];
      }
      values[k * components + c] = sum;
    }
  }
  std::vector<double> edge((degree + 1) * components);
  for (int side = 0; side < 3; ++side)
  {
    const auto at = [&](int k) {
      return components * (side == 0 ? k : GetTriangleIndex(degree, side == 1 ? 0 : degree - k, k));
    };
    for (int k = 0; k <= degree; ++k)
    {
      std::copy_n(&nodes[at(k)], components, &edge[k * components]);
    }
    ConvertLagrangeToBezier(degree, components, edge.data(), components);
    for (int k = 0; k <= degree; ++k)
    {
      std::copy_n(&edge[k * components], components, values + at(k));
    }
  }
}
}

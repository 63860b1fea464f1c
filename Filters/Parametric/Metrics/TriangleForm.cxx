// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/TriangleForm.h"

#include "Mathematics/TriangleIndex.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// A polynomial on a triangle, given by its Bézier points.
using Polynomial = std::vector<dvec4>;

// Returns the sum of polynomials of equal degree, each multiplied by a linear function, which is
// given at the corners.
Polynomial Blend(
  int degree, std::initializer_list<std::pair<const dvec3*, const Polynomial*>> terms)
{
  const int n = degree + 1;
  Polynomial result(GetTriangleIndex(n, 0, n) + 1, dvec4(0.0));
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j + k <= n; ++j)
    {
      const int i = n - j - k;
      dvec4 sum(0.0);
      for (const auto& term : terms)
      {
        const dvec3& f = *term.first;
        const Polynomial& p = *term.second;
        sum += i > 0 ? i * f[0] * p[GetTriangleIndex(degree, j, k)] : dvec4(0.0);
        sum += j > 0 ? j * f[1] * p[GetTriangleIndex(degree, j - 1, k)] : dvec4(0.0);
        sum += k > 0 ? k * f[2] * p[GetTriangleIndex(degree, j, k - 1)] : dvec4(0.0);
      }
      result[GetTriangleIndex(n, j, k)] = sum / static_cast<double>(n);
    }
  }
  return result;
}

// Applies de Casteljau's algorithm to a row of polynomials of equal degree, with a linear function
// as the parameter.
Polynomial BlendRow(std::vector<Polynomial> row, int degree, const dvec3& t)
{
  const dvec3 s = dvec3(1.0) - t;
  for (; row.size() > 1; row.pop_back(), ++degree)
  {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
    {
      row[i] = Blend(degree, { { &s, &row[i] }, { &t, &row[i + 1] } });
    }
  }
  return std::move(row.front());
}

// Does the same for a triangle of points, in the order of GetTriangleIndex(), with linear functions
// as barycentric coordinates.
Polynomial BlendTriangle(const std::vector<dvec4>& points, int size, const dvec3 coordinates[3])
{
  std::vector<Polynomial> net;
  for (const dvec4& point : points)
  {
    net.push_back({ point });
  }
  for (int n = size; n > 0; --n)
  {
    std::vector<Polynomial> next;
    for (int k = 0; k < n; ++k)
    {
      for (int j = 0; j + k < n; ++j)
      {
        next.push_back(Blend(size - n,
          { { &coordinates[0], &net[GetTriangleIndex(n, j, k)] },
            { &coordinates[1], &net[GetTriangleIndex(n, j + 1, k)] },
            { &coordinates[2], &net[GetTriangleIndex(n, j, k + 1)] } }));
      }
    }
    net.swap(next);
  }
  return std::move(net.front());
}
}

TriangleForm::TriangleForm(
  const PatchArrays& patches, const Patch& patch, const dvec2 corners[3], const dvec3& origin)
{
  const auto getPoint = [&](int i)
  {
    const dvec4 point = patches.GetPoint(patch.FirstPoint + i);
    return dvec4((dvec3(point) - origin) * point.w, point.w);
  };
  const dvec3 u(corners[0].x, corners[1].x, corners[2].x);
  const dvec3 v(corners[0].y, corners[1].y, corners[2].y);
  if (patch.IsTriangle)
  {
    std::vector<dvec4> points;
    for (int i = 0; i < patch.GetNumberOfPoints(); ++i)
    {
      points.push_back(getPoint(i));
    }
    const dvec3 coordinates[3] = { dvec3(1.0) - u - v, u, v };
    this->Degree = patch.Degrees.x;
    this->Points = BlendTriangle(points, this->Degree, coordinates);
    return;
  }
  this->Degree = patch.Degrees.x + patch.Degrees.y;
  std::vector<Polynomial> column;
  for (int j = 0; j <= patch.Degrees.y; ++j)
  {
    std::vector<Polynomial> row;
    for (int i = 0; i <= patch.Degrees.x; ++i)
    {
      row.push_back({ getPoint(j * (patch.Degrees.x + 1) + i) });
    }
    column.push_back(BlendRow(std::move(row), 0, u));
  }
  this->Points = BlendRow(std::move(column), patch.Degrees.x, v);
}

TriangleForm::TriangleForm(const TriangleForm& form, const dvec3 corners[3])
  : Degree(form.Degree)
{
  const dvec3 coordinates[3] = { dvec3(corners[0].x, corners[1].x, corners[2].x),
    dvec3(corners[0].y, corners[1].y, corners[2].y),
    dvec3(corners[0].z, corners[1].z, corners[2].z) };
  this->Points = BlendTriangle(form.Points, form.Degree, coordinates);
}

bool TriangleForm::IsRational() const
{
  const double weight = this->Points[0].w;
  return std::any_of(this->Points.begin(), this->Points.end(),
    [weight](const dvec4& point) { return std::abs(point.w - weight) > 1e-9 * weight; });
}

std::vector<dvec4> TriangleForm::GetEdge(int corner) const
{
  std::vector<dvec4> result;
  for (int i = 0; i <= this->Degree; ++i)
  {
    const int rest = this->Degree - i;
    const ivec2 exponents =
      corner == 0 ? ivec2(rest, i) : (corner == 1 ? ivec2(0, i) : ivec2(i, 0));
    result.push_back(this->Points[GetTriangleIndex(this->Degree, exponents.x, exponents.y)]);
  }
  return result;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/PatchEvaluation.h"

#include "Mathematics/TriangleIndex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// A homogeneous point with its derivatives.
struct Derivatives
{
  dvec4 Value;
  dvec4 U;
  dvec4 V;
};

// Evaluates a curve; U is the derivative.
Derivatives EvaluateHomogeneous(ControlPoints& points, double t)
{
  const std::size_t degree = points.size() - 1;
  for (std::size_t k = degree; k > 1; --k)
  {
    for (std::size_t i = 0; i < k; ++i)
    {
      points[i] = (1.0 - t) * points[i] + t * points[i + 1];
    }
  }
  return { (1.0 - t) * points[0] + t * points[1],
    static_cast<double>(degree) * (points[1] - points[0]), dvec4(0.0) };
}

Derivatives EvaluateQuadrilateral(const FacePatch& patch, const dvec4* points, const dvec2& uv)
{
  const int size = patch.Degrees.x + 1;
  ControlPoints values;
  ControlPoints slopes;
  for (int j = 0; j <= patch.Degrees.y; ++j)
  {
    ControlPoints row(points + j * size, points + (j + 1) * size);
    const Derivatives across = EvaluateHomogeneous(row, uv.x);
    values.push_back(across.Value);
    slopes.push_back(across.U);
  }
  const Derivatives along = EvaluateHomogeneous(values, uv.y);
  return { along.Value, EvaluateHomogeneous(slopes, uv.y).Value, along.U };
}

Derivatives EvaluateTriangle(const FacePatch& patch, const dvec4* points, const dvec2& uv)
{
  const int degree = patch.Degrees.x;
  const double rest = 1.0 - uv.x - uv.y;
  ControlPoints net(points, points + patch.GetNumberOfPoints());
  for (int n = degree; n > 1; --n)
  {
    ControlPoints next;
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n - j; ++i)
      {
        next.push_back(rest * net[GetTriangleIndex(n, i, j)] +
          uv.x * net[GetTriangleIndex(n, i + 1, j)] + uv.y * net[GetTriangleIndex(n, i, j + 1)]);
      }
    }
    net = next;
  }
  const double factor = degree;
  return { rest * net[0] + uv.x * net[1] + uv.y * net[2], factor * (net[1] - net[0]),
    factor * (net[2] - net[0]) };
}

Derivatives Evaluate(const FacePatch& patch, const ControlPoints& points, const dvec2& uv)
{
  const dvec4* first = points.data() + patch.FirstPoint;
  return patch.IsTriangle ? EvaluateTriangle(patch, first, uv)
                          : EvaluateQuadrilateral(patch, first, uv);
}

dvec3 Project(const dvec4& point)
{
  return dvec3(point) / point.w;
}

// Returns 0 if the normal is undefined.
dvec3 EvaluateRegularNormal(
  const FacePatch& patch, const ControlPoints& points, const dvec2& uv, double size)
{
  const Derivatives at = Evaluate(patch, points, uv);
  const dvec3 x = Project(at.Value);
  const dvec3 u = (dvec3(at.U) - x * at.U.w) / at.Value.w;
  const dvec3 v = (dvec3(at.V) - x * at.V.w) / at.Value.w;
  const dvec3 normal = cross(u, v);
  const double area = length(normal);
  const bool isRegular = area > 1e-12 * size * size && area > 1e-8 * length(u) * length(v);
  return isRegular ? normal / area : dvec3(0.0);
}

std::vector<double> EvaluateBernstein(int degree, double t)
{
  std::vector<double> values{ 1.0 };
  for (int n = 1; n <= degree; ++n)
  {
    values.push_back(0.0);
    for (int i = n; i >= 0; --i)
    {
      values[i] = (1.0 - t) * values[i] + (i ? t * values[i - 1] : 0.0);
    }
  }
  return values;
}

std::vector<double> EvaluateTriangleBernstein(int degree, const dvec2& uv)
{
  std::vector<double> values{ 1.0 };
  for (int n = 1; n <= degree; ++n)
  {
    std::vector<double> next((n + 1) * (n + 2) / 2, 0.0);
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n - j; ++i)
      {
        const double value = values[GetTriangleIndex(n - 1, i, j)];
        next[GetTriangleIndex(n, i, j)] += (1.0 - uv.x - uv.y) * value;
        next[GetTriangleIndex(n, i + 1, j)] += uv.x * value;
        next[GetTriangleIndex(n, i, j + 1)] += uv.y * value;
      }
    }
    values = next;
  }
  return values;
}
}

dvec2 FacePatch::GetCorner(int corner) const
{
  return this->IsTriangle ? dvec2(corner == 1, corner == 2)
                          : dvec2(corner == 1 || corner == 2, corner >= 2);
}

std::vector<int> FacePatch::GetBorder(int border) const
{
  const ivec2 p = this->Degrees;
  const int degree = this->IsTriangle || border % 2 == 0 ? p.x : p.y;
  std::vector<int> points;
  for (int k = 0; k <= degree; ++k)
  {
    const int rest = degree - k;
    if (this->IsTriangle)
    {
      const std::array<ivec2, 3> at{ ivec2(k, 0), ivec2(rest, k), ivec2(0, rest) };
      points.push_back(GetTriangleIndex(degree, at[border].x, at[border].y));
    }
    else
    {
      const std::array<ivec2, 4> at{ ivec2(k, 0), ivec2(p.x, k), ivec2(rest, p.y), ivec2(0, rest) };
      points.push_back(at[border].y * (p.x + 1) + at[border].x);
    }
  }
  return points;
}

bool HasArea(const FacePatch& patch, const ControlPoints& points)
{
  const dvec3 origin = Project(points[patch.FirstPoint]);
  dvec3 farthest(0.0);
  double size = length(origin);
  for (int i = 1; i < patch.GetNumberOfPoints(); ++i)
  {
    const dvec3 x = Project(points[patch.FirstPoint + i]) - origin;
    farthest = length(x) > length(farthest) ? x : farthest;
  }
  size += length(farthest);
  double distance = 0.0;
  for (int i = 1; i < patch.GetNumberOfPoints() && farthest != dvec3(0.0); ++i)
  {
    const dvec3 x = Project(points[patch.FirstPoint + i]) - origin;
    distance = std::max(distance, length(cross(x, farthest / length(farthest))));
  }
  return distance > 8.0 * std::numeric_limits<double>::epsilon() * size;
}

dvec3 EvaluateCurve(ControlPoints points, double t)
{
  return Project(EvaluateHomogeneous(points, t).Value);
}

dvec3 EvaluatePoint(const FacePatch& patch, const ControlPoints& points, const dvec2& uv)
{
  return Project(Evaluate(patch, points, uv).Value);
}

dvec3 EvaluateNormal(const FacePatch& patch, const ControlPoints& points, const dvec2& uv)
{
  const dvec3 origin = Project(points[patch.FirstPoint]);
  double size = 0.0;
  for (int i = 1; i < patch.GetNumberOfPoints(); ++i)
  {
    size = std::max(size, length(Project(points[patch.FirstPoint + i]) - origin));
  }
  const dvec3 normal = EvaluateRegularNormal(patch, points, uv, size);
  if (normal != dvec3(0.0))
  {
    return normal;
  }
  // Extrapolate from two nearby points.
  constexpr double step = 1.0 / 1024.0;
  const dvec2 inwards = patch.GetMiddle() - uv;
  const dvec3 near = EvaluateRegularNormal(patch, points, uv + step * inwards, size);
  const dvec3 far = EvaluateRegularNormal(patch, points, uv + 2.0 * step * inwards, size);
  const dvec3 limit = 2.0 * near - far;
  const double area = length(limit);
  return area > 0.0 ? limit / area : dvec3(0.0);
}

std::vector<double> EvaluateShares(
  const FacePatch& patch, const ControlPoints& points, const dvec2& uv)
{
  std::vector<double> shares;
  if (patch.IsTriangle)
  {
    shares = EvaluateTriangleBernstein(patch.Degrees.x, uv);
  }
  else
  {
    const std::vector<double> u = EvaluateBernstein(patch.Degrees.x, uv.x);
    for (double v : EvaluateBernstein(patch.Degrees.y, uv.y))
    {
      std::transform(
        u.begin(), u.end(), std::back_inserter(shares), [v](double value) { return value * v; });
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    shares[i] *= points[patch.FirstPoint + i].w;
    sum += shares[i];
  }
  for (double& share : shares)
  {
    share /= sum;
  }
  return shares;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Distance/TriangleTree.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
double GetBoxDistance2(const FloatBox& box, const dvec3& point)
{
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double d =
      std::max({ 0.0, double(box.Low[c]) - point[c], point[c] - double(box.High[c]) });
    sum += d * d;
  }
  return sum;
}

// The smallest |t| up to `range` for which the line is in the box, or more than `range`. The margin
// covers the rounding of boxes to floats.
double GetBoxParameter(
  const FloatBox& box, const dvec3& point, const dvec3& direction, double range)
{
  constexpr double margin = 1e-6;
  const double outside = 2.0 * range + 1.0;
  double first = -range;
  double last = range;
  for (int c = 0; c < 3; ++c)
  {
    const double low = double(box.Low[c]) - margin - point[c];
    const double high = double(box.High[c]) + margin - point[c];
    if (direction[c] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return outside;
      }
      continue;
    }
    const double a = low / direction[c];
    const double b = high / direction[c];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (first > last)
  {
    return outside;
  }
  return std::max({ 0.0, first, -last });
}

// The weights of the corners b and c at the nearest point of a triangle; see C. Ericson, "Real-Time
// Collision Detection", 2005, section 5.1.5.
dvec2 FindNearestWeights(const dvec3& point, const dvec3& a, const dvec3& b, const dvec3& c)
{
  const dvec3 ab = b - a;
  const dvec3 ac = c - a;
  const double abA = dot(ab, point - a);
  const double acA = dot(ac, point - a);
  if (abA <= 0.0 && acA <= 0.0)
  {
    return dvec2(0.0);
  }
  const double abB = dot(ab, point - b);
  const double acB = dot(ac, point - b);
  if (abB >= 0.0 && acB <= abB)
  {
    return dvec2(1.0, 0.0);
  }
  const double abC = dot(ab, point - c);
  const double acC = dot(ac, point - c);
  if (acC >= 0.0 && abC <= acC)
  {
    return dvec2(0.0, 1.0);
  }
  const double areaC = abA * acB - abB * acA;
  if (areaC <= 0.0 && abA >= 0.0 && abB <= 0.0 && abA > abB)
  {
    return dvec2(abA / (abA - abB), 0.0);
  }
  const double areaB = abC * acA - abA * acC;
  if (areaB <= 0.0 && acA >= 0.0 && acC <= 0.0 && acA > acC)
  {
    return dvec2(0.0, acA / (acA - acC));
  }
  const double areaA = abB * acC - abC * acB;
  const double alongB = acB - abB;
  const double alongC = abC - acC;
  if (areaA <= 0.0 && alongB >= 0.0 && alongC >= 0.0 && alongB + alongC > 0.0)
  {
    const double w = alongB / (alongB + alongC);
    return dvec2(1.0 - w, w);
  }
  const double sum = areaA + areaB + areaC;
  return sum > 0.0 ? dvec2(areaB / sum, areaC / sum) : dvec2(0.0);
}
}

TriangleTree::TriangleTree(const std::vector<dvec3>& points, const std::vector<Triangle>& triangles)
  : Points(points)
  , Triangles(triangles)
{
  std::vector<FloatBox> boxes(triangles.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        for (int c = 0; c < 3; ++c)
        {
          const vec3 point(this->GetPoint(static_cast<int>(t), c));
          boxes[static_cast<std::size_t>(t)].Add(&point.x);
        }
      }
    });
  this->Tree.Build(boxes);
}

dvec3 TriangleTree::GetNearestPoint(const dvec3& point, int triangle) const
{
  const dvec3& a = this->GetPoint(triangle, 0);
  const dvec3& b = this->GetPoint(triangle, 1);
  const dvec3& c = this->GetPoint(triangle, 2);
  const dvec2 weights = FindNearestWeights(point, a, b, c);
  return a + weights.x * (b - a) + weights.y * (c - a);
}

double TriangleTree::GetDistance2(const dvec3& point, int triangle) const
{
  const dvec3 offset = point - this->GetNearestPoint(point, triangle);
  return dot(offset, offset);
}

dvec3 TriangleTree::GetNormal(int triangle) const
{
  const dvec3& a = this->GetPoint(triangle, 0);
  return cross(this->GetPoint(triangle, 1) - a, this->GetPoint(triangle, 2) - a);
}

void TriangleTree::FindNearest(const dvec3& point, double& distance2, int& triangle) const
{
  this->Tree.Visit(
    distance2, [&](const FloatBox& box, double) { return GetBoxDistance2(box, point); },
    [&](int t)
    {
      const double found = this->GetDistance2(point, t);
      if (found < distance2 || (found == distance2 && t < triangle))
      {
        distance2 = found;
        triangle = t;
      }
    });
}

bool TriangleTree::Intersect(
  const dvec3& point, const dvec3& direction, double range, double& t, int& triangle) const
{
  double nearest = range;
  bool isFound = false;
  this->Tree.Visit(
    nearest,
    [&](const FloatBox& box, double last) { return GetBoxParameter(box, point, direction, last); },
    [&](int candidate)
    {
      const dvec3& a = this->GetPoint(candidate, 0);
      const dvec3 ab = this->GetPoint(candidate, 1) - a;
      const dvec3 ac = this->GetPoint(candidate, 2) - a;
      const dvec3 across = cross(direction, ac);
      const double determinant = dot(ab, across);
      if (!(determinant < 0.0)) // the normal is ab x ac
      {
        return;
      }
      const dvec3 offset = point - a;
      const double u = dot(offset, across) / determinant;
      const dvec3 other = cross(offset, ab);
      const double v = dot(direction, other) / determinant;
      constexpr double slack = 1e-9; // lines through edges hit at least one of the triangles
      if (u < -slack || v < -slack || u + v > 1.0 + slack)
      {
        return;
      }
      const double found = dot(ac, other) / determinant;
      if (std::abs(found) < nearest)
      {
        nearest = std::abs(found);
        t = found;
        triangle = candidate;
        isFound = true;
      }
    });
  return isFound;
}
}

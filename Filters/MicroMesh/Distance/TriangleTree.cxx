// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Distance/TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// The enlargement of boxes, more than the rounding of coordinates and of differences to floats.
constexpr float Margin = 5e-7f;

// Squared distances of a point to boxes.
struct PointDistances
{
  void operator()(const WideBoxTree::Node& node, WideBoxTree::Lanes& lanes) const
  {
    lanes.fill(0.0f);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const float coordinate = this->Point[static_cast<int>(c)];
      for (std::size_t i = 0; i < WideBoxTree::Width; ++i)
      {
        const float below = node.Low[c][i] - coordinate;
        const float above = coordinate - node.High[c][i];
        const float larger = below > above ? below : above;
        const float d = larger > 0.0f ? larger : 0.0f;
        lanes[i] += d * d;
      }
    }
  }

  vec3 Point;
};

// The smallest |t| up to a range for which a line is in boxes, or infinity.
struct LineDistances
{
  LineDistances(const dvec3& point, const dvec3& direction, double range)
    : Point(point)
    , Range(static_cast<float>(range))
  {
    constexpr double least = 1e-30;
    for (int c = 0; c < 3; ++c)
    {
      const double d = direction[c];
      this->Inverse[c] = static_cast<float>(1.0 / (std::abs(d) < least ? least : d));
    }
  }

  void operator()(const WideBoxTree::Node& node, WideBoxTree::Lanes& lanes) const
  {
    WideBoxTree::Lanes first;
    WideBoxTree::Lanes last;
    first.fill(-this->Range);
    last.fill(this->Range);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const float coordinate = this->Point[static_cast<int>(c)];
      const float inverse = this->Inverse[static_cast<int>(c)];
      for (std::size_t i = 0; i < WideBoxTree::Width; ++i)
      {
        const float a = (node.Low[c][i] - coordinate) * inverse;
        const float b = (node.High[c][i] - coordinate) * inverse;
        const float lower = a < b ? a : b;
        const float higher = a < b ? b : a;
        first[i] = lower > first[i] ? lower : first[i];
        last[i] = higher < last[i] ? higher : last[i];
      }
    }
    for (std::size_t i = 0; i < WideBoxTree::Width; ++i)
    {
      const float before = first[i] > -last[i] ? first[i] : -last[i];
      const float nearest = before > 0.0f ? before : 0.0f;
      lanes[i] = first[i] <= last[i] ? nearest : FloatBox::Infinity;
    }
  }

  vec3 Point;
  vec3 Inverse;
  float Range;
};

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
  this->Tree.Build(static_cast<int>(triangles.size()),
    [this](int triangle)
    {
      FloatBox box;
      for (int c = 0; c < 3; ++c)
      {
        const vec3 point(this->GetPoint(triangle, c));
        box.Add(&point.x);
      }
      for (std::size_t c = 0; c < 3; ++c)
      {
        box.Low[c] -= Margin;
        box.High[c] += Margin;
      }
      return box;
    });
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
  this->Tree.Visit(distance2, PointDistances{ vec3(point) },
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
  this->Tree.Visit(nearest, LineDistances(point, direction, range),
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

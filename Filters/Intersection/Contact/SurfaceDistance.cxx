// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SurfaceDistance.h"

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/MovedSurface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
struct Corners
{
  dvec3 Points[3];
};

double GetSquare(const dvec3& v)
{
  return dot(v, v);
}

// Between segments p q and a b: C. Ericson, "Real-Time Collision Detection" (2005), 5.1.9.
double GetSegmentSquare(const dvec3& p, const dvec3& q, const dvec3& a, const dvec3& b)
{
  const dvec3 d = q - p;
  const dvec3 e = b - a;
  const dvec3 r = p - a;
  const double dd = dot(d, d);
  const double ee = dot(e, e);
  const double de = dot(d, e);
  const double dr = dot(d, r);
  const double er = dot(e, r);
  const double denominator = dd * ee - de * de;
  double s = denominator > 0.0 ? clamp((de * er - dr * ee) / denominator, 0.0, 1.0) : 0.0;
  double t = ee > 0.0 ? (de * s + er) / ee : 0.0;
  if (t < 0.0 || t > 1.0)
  {
    t = clamp(t, 0.0, 1.0);
    s = dd > 0.0 ? clamp((de * t - dr) / dd, 0.0, 1.0) : 0.0;
  }
  return GetSquare(r + s * d - t * e);
}

// From a point to the interior of a triangle if it projects to it, otherwise infinity. Edges are
// measured separately.
double GetFaceSquare(const dvec3& point, const Corners& triangle)
{
  const dvec3& a = triangle.Points[0];
  const dvec3 normal = cross(triangle.Points[1] - a, triangle.Points[2] - a);
  for (int i = 0; i < 3; ++i)
  {
    const dvec3& from = triangle.Points[i];
    const dvec3 inwards = cross(normal, triangle.Points[(i + 1) % 3] - from);
    if (!(dot(inwards, point - from) >= 0.0))
    {
      return DoubleBox::Infinity;
    }
  }
  const double height = dot(normal, point - a);
  const double square = height * height / GetSquare(normal);
  return std::isfinite(square) ? square : DoubleBox::Infinity;
}

double GetTriangleSquare(const Corners& a, const Corners& b)
{
  double square = DoubleBox::Infinity;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      square = std::min(square,
        GetSegmentSquare(a.Points[i], a.Points[(i + 1) % 3], b.Points[j], b.Points[(j + 1) % 3]));
    }
    square = std::min(square, GetFaceSquare(a.Points[i], b));
    square = std::min(square, GetFaceSquare(b.Points[i], a));
  }
  return square;
}

double GetBoxSquare(const DoubleBox& a, const DoubleBox& b, double unit)
{
  double square = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double gap = std::max({ a.Low[c] - b.High[c], b.Low[c] - a.High[c], 0.0 }) * unit;
    square += gap * gap;
  }
  // Rounding errors must not exclude boxes at the same distance.
  return square * (1.0 - 1e-12);
}

DoubleBox GetBox(const MovedSurface& surface, vtkIdType triangle)
{
  DoubleBox box;
  for (const double* point : surface.GetPoints(triangle))
  {
    box.Add(point);
  }
  return box;
}

Corners GetCorners(const MovedSurface& surface, vtkIdType triangle, double unit)
{
  const auto points = surface.GetPoints(triangle);
  Corners corners;
  for (int i = 0; i < 3; ++i)
  {
    corners.Points[i] = unit * dvec3(points[i][0], points[i][1], points[i][2]);
  }
  return corners;
}

double GetReach(const DoubleBox& box)
{
  double reach = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    reach = std::max({ reach, std::abs(box.Low[c]), std::abs(box.High[c]) });
  }
  return reach;
}
}

SurfaceDistance::SurfaceDistance(const MovedSurface& from, const MovedSurface& to)
  : From(from)
  , To(to)
{
  const double reach = std::max(GetReach(from.GetTree().GetNodes().front().Bounds),
    GetReach(to.GetTree().GetNodes().front().Bounds));
  // Avoids infinity for very small surfaces.
  this->Unit = std::ldexp(1.0, std::min(-std::ilogb(reach), 1000));
}

double SurfaceDistance::Square(vtkIdType triangle, vtkIdType other) const
{
  const double square = GetTriangleSquare(
    GetCorners(this->From, triangle, this->Unit), GetCorners(this->To, other, this->Unit));
  // Rounding errors, for example for a triangle of size 1e38, can make this smaller than the
  // distance of the boxes. The larger one is used, because the search skips boxes by their
  // distance, and its order must not affect the result.
  return std::max(
    square, GetBoxSquare(GetBox(this->From, triangle), GetBox(this->To, other), this->Unit));
}

double SurfaceDistance::GetLength(double square) const
{
  return std::sqrt(square) / this->Unit;
}

void SurfaceDistance::Lower(vtkIdType triangle, vtkIdType& nearest, double& square) const
{
  const DoubleBoxTree& tree = this->To.GetTree();
  const DoubleBox box = GetBox(this->From, triangle);
  if (nearest >= 0)
  {
    square = std::min(square, this->Square(triangle, nearest));
  }
  std::vector<std::pair<vtkIdType, double>> stack{ { 0, 0.0 } };
  while (!stack.empty())
  {
    const auto top = stack.back();
    stack.pop_back();
    if (top.second > square)
    {
      continue;
    }
    const DoubleBoxTree::Node& node = tree.GetNodes()[top.first];
    for (vtkIdType i = node.First; i < node.First + node.Count; ++i)
    {
      const vtkIdType other = tree.GetItem(i);
      if (this->To.HasArea(other) && GetBoxSquare(box, tree.GetBox(i), this->Unit) <= square)
      {
        const double candidate = this->Square(triangle, other);
        nearest = candidate < square ? other : nearest;
        square = std::min(square, candidate);
      }
    }
    if (node.Count == 0)
    {
      const auto getChild = [&](vtkIdType child) {
        return std::make_pair(child, GetBoxSquare(box, tree.GetNodes()[child].Bounds, this->Unit));
      };
      auto near = getChild(top.first + 1);
      auto far = getChild(node.First);
      if (far.second < near.second)
      {
        std::swap(near, far);
      }
      stack.push_back(far);
      stack.push_back(near);
    }
  }
}
}

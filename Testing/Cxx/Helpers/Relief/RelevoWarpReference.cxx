// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoWarpReference.h"

#include "Data/ReliefSides.h"

#include "vtkCamera.h"

#include <cmath>
#include <limits>

using relevo::dvec2;
using relevo::dvec3;
using relevo::dvec4;

RelevoWarpReference::RelevoWarpReference(
  vtkImageData* image, vtkCamera* camera, double maximumStretch)
{
  this->Relief.Read(image);
  this->Sides = relevo::FindReliefSides(this->Relief, maximumStretch);
  dvec4 eye(0.0, 0.0, 0.0, 1.0);
  if (camera->GetParallelProjection())
  {
    camera->GetDirectionOfProjection(&eye.x);
    eye = -eye;
    eye.w = 0.0;
  }
  else
  {
    camera->GetPosition(&eye.x);
  }
  this->Eye = this->Relief.GetWorldToTexel() * eye;
}

dvec3 RelevoWarpReference::GetPoint(double column, double row, double height) const
{
  const dvec4 plane(column, row, this->Relief.GetPlane(), 1.0);
  // (plane.z + s eye.z) / (1 + s eye.w) is the height.
  const double share = (height - plane.z) / (this->Eye.z - height * this->Eye.w);
  const dvec4 point = plane + share * this->Eye;
  return dvec3(point) / point.w;
}

dvec2 RelevoWarpReference::Project(int column, int row) const
{
  const dvec4 point(column, row, this->Relief.GetTexelHeight(column, row), 1.0);
  const double plane = this->Relief.GetPlane();
  const double share = (plane - point.z) / (this->Eye.z - plane * this->Eye.w);
  const dvec4 place = point + share * this->Eye;
  return dvec2(place) / place.w;
}

dvec3 RelevoWarpReference::Cast(double column, double row) const
{
  // The line is straight in texel space, so two of its points determine it.
  const dvec2 range = this->Relief.GetHeightRange();
  const double low = range.x - 1.0;
  const double high = range.y + 1.0;
  const dvec3 first = this->GetPoint(column, row, low);
  const dvec3 second = this->GetPoint(column, row, high);
  const dvec2 slope = (dvec2(second) - dvec2(first)) / (high - low);
  const dvec2 start = dvec2(first) - slope * low;
  dvec3 nearest(std::numeric_limits<double>::quiet_NaN());
  const int width = this->Relief.GetWidth();
  for (size_t i = 0; i < this->Sides.size(); ++i)
  {
    if (this->Sides[i] & relevo::Quad)
    {
      this->CastQuad(
        static_cast<int>(i % width), static_cast<int>(i / width), start, slope, nearest);
    }
  }
  return nearest;
}

void RelevoWarpReference::CastQuad(
  int column, int row, const dvec2& start, const dvec2& slope, dvec3& nearest) const
{
  constexpr double slack = 1e-9;
  const auto height = [&](int right, int up)
  { return this->Relief.GetTexelHeight(column + right, row + up); };
  // h = a + b x + c y + d x y with x = px + qx h and y = py + qy h.
  const double a = height(0, 0);
  const double b = height(1, 0) - a;
  const double c = height(0, 1) - a;
  const double d = height(1, 1) - a - b - c;
  const double px = start.x - column;
  const double py = start.y - row;
  const double squared = d * slope.x * slope.y;
  const double linear = b * slope.x + c * slope.y + d * (px * slope.y + py * slope.x) - 1.0;
  const double constant = a + b * px + c * py + d * px * py;
  double roots[2];
  if (std::abs(squared) < 1e-14 * std::abs(linear))
  {
    roots[0] = roots[1] = -constant / linear;
  }
  else
  {
    const double root = std::sqrt(linear * linear - 4.0 * squared * constant);
    const double sum = -0.5 * (linear + (linear < 0.0 ? -root : root));
    roots[0] = sum / squared;
    roots[1] = constant / sum;
  }
  for (double h : roots)
  {
    const double x = px + slope.x * h;
    const double y = py + slope.y * h;
    // A point is in front of the eye if it is on the plane's side of it, in homogeneous
    // coordinates.
    const double eye = this->Eye.z - h * this->Eye.w;
    const double plane = this->Eye.z - this->Relief.GetPlane() * this->Eye.w;
    const bool isHit =
      x > -slack && x < 1.0 + slack && y > -slack && y < 1.0 + slack && eye * plane > 0.0;
    const bool isNearer = this->Relief.IsPerspective() ? !(h <= nearest.z) : !(h >= nearest.z);
    if (isHit && isNearer)
    {
      nearest = dvec3(column + x, row + y, h);
    }
  }
}

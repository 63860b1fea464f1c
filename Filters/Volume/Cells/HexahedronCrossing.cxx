// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/HexahedronCrossing.h"

#include "vtkCellType.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// In parameters. Hits slightly outside of a face are accepted.
constexpr double ParameterMargin = 1e-6;
constexpr int MostNewtonSteps = 12;
// The square of a step. Convergence is quadratic, so that the remaining error is about this small.
constexpr double LastStep = 1e-11;

struct HexahedronFace
{
  std::array<int, 4> Corners;
  int Side; // the axis of the parameter that is constant
  double Value;
  int U; // the axes of the parameters along the first and the last edge
  int V;
};
constexpr std::array<HexahedronFace, 6> HexahedronFaces = { { { { { 0, 3, 7, 4 } }, 0, 0.0, 1, 2 },
  { { { 1, 2, 6, 5 } }, 0, 1.0, 1, 2 }, { { { 0, 1, 5, 4 } }, 1, 0.0, 0, 2 },
  { { { 3, 2, 6, 7 } }, 1, 1.0, 0, 2 }, { { { 0, 1, 2, 3 } }, 2, 0.0, 0, 1 },
  { { { 4, 5, 6, 7 } }, 2, 1.0, 0, 1 } } };

double Cross2(double ax, double ay, double bx, double by)
{
  return ax * by - ay * bx;
}

// Whether a range, widened by the margin of parameters, contains 0.
bool Contains0(double a, double b, double c, double d)
{
  const double low = std::min(std::min(a, b), std::min(c, d));
  const double high = std::max(std::max(a, b), std::max(c, d));
  const double margin = 2.0 * ParameterMargin * (high - low);
  return low <= margin && high >= -margin;
}

bool IsInFace(double u)
{
  return u >= -ParameterMargin && u <= 1.0 + ParameterMargin;
}
}

const HexahedronCrossing::Corners* HexahedronCrossing::FindCorners(const CellShape* shape)
{
  static const std::array<std::pair<const CellShape*, Corners>, 3> all = {
    { { FindCellShape(VTK_HEXAHEDRON), { { 0, 1, 2, 3, 4, 5, 6, 7 } } },
      { FindCellShape(VTK_WEDGE), { { 0, 1, 2, 2, 3, 4, 5, 5 } } },
      { FindCellShape(VTK_PYRAMID), { { 0, 1, 2, 3, 4, 4, 4, 4 } } } }
  };
  for (const auto& each : all)
  {
    if (each.first == shape)
    {
      return &each.second;
    }
  }
  return nullptr;
}

// In the plane perpendicular to the ray, the hit satisfies 0 = a + u b + v c + u v d. So a + v c
// and b + v d are parallel, which is a quadratic equation for v.
void HexahedronCrossing::CrossFace(int number)
{
  const HexahedronFace& face = HexahedronFaces[static_cast<size_t>(number)];
  const dvec3& p0 = this->Seen[face.Corners[0]];
  const dvec3& p1 = this->Seen[face.Corners[1]];
  const dvec3& p2 = this->Seen[face.Corners[2]];
  const dvec3& p3 = this->Seen[face.Corners[3]];
  if (!Contains0(p0.x, p1.x, p2.x, p3.x) || !Contains0(p0.y, p1.y, p2.y, p3.y))
  {
    return;
  }
  const dvec3 b = p1 - p0;
  const dvec3 c = p3 - p0;
  const dvec3 d = p2 - p1 - c;
  const double square = Cross2(c.x, c.y, d.x, d.y);
  const double linear = Cross2(p0.x, p0.y, d.x, d.y) + Cross2(c.x, c.y, b.x, b.y);
  const double constant = Cross2(p0.x, p0.y, b.x, b.y);
  const double discriminant = std::max(linear * linear - 4.0 * square * constant, 0.0);
  const double q = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
  for (const double v : { q / square, constant / q })
  {
    if (!IsInFace(v)) // also NaN
    {
      continue;
    }
    const double x = b.x + v * d.x;
    const double y = b.y + v * d.y;
    const double u = -((p0.x + v * c.x) * x + (p0.y + v * c.y) * y) / (x * x + y * y);
    if (IsInFace(u))
    {
      Hit& hit = this->Hits[this->NumberOfHits++];
      hit.Depth = p0.z + u * b.z + v * c.z + u * v * d.z;
      hit.Parameters[face.Side] = face.Value;
      hit.Parameters[face.U] = u;
      hit.Parameters[face.V] = v;
    }
  }
}

HexahedronCrossing::Result HexahedronCrossing::Cross(
  const Ray& ray, const AcrossRay& across, double shortest)
{
  for (int i = 0; i < NumberOfCorners; ++i)
  {
    const dvec3 from = this->Points[i] - ray.Origin;
    this->Seen[i] = dvec3(across(from), dot(from, ray.Direction));
  }
  this->NumberOfHits = 0;
  for (int face = 0; face < 6; ++face)
  {
    this->CrossFace(face);
  }
  if (this->NumberOfHits == 0)
  {
    return Result::Missed;
  }
  std::sort(this->Hits.begin(), this->Hits.begin() + this->NumberOfHits,
    [](const Hit& a, const Hit& b) { return a.Depth < b.Depth; });
  // HexahedronFaces with a common edge report it twice.
  int count = 1;
  for (int i = 1; i < this->NumberOfHits; ++i)
  {
    if (this->Hits[i].Depth - this->Hits[count - 1].Depth > shortest)
    {
      this->Hits[count++] = this->Hits[i];
    }
  }
  if (count != 2)
  {
    return Result::Unclear;
  }
  this->Ends = { { this->Hits[0], this->Hits[1] } };
  this->Begin = std::max(this->Ends[0].Depth, 0.0);
  this->End = std::min(this->Ends[1].Depth, ray.Length);
  return this->End - this->Begin > shortest ? Result::Crossed : Result::Missed;
}

void HexahedronCrossing::FindTerms()
{
  const auto& p = this->Seen;
  auto& t = this->Terms;
  t[0] = p[0];
  t[1] = p[1] - p[0];
  t[2] = p[3] - p[0];
  t[3] = p[4] - p[0];
  t[4] = p[2] - p[3] - t[1];
  t[5] = p[7] - p[4] - t[2];
  t[6] = p[5] - p[4] - t[1];
  t[7] = p[6] - p[7] - t[1] - t[4] - t[6];
}

bool HexahedronCrossing::Locate(double depth, dvec3& p) const
{
  const auto& t = this->Terms;
  for (int i = 0; i < MostNewtonSteps; ++i)
  {
    const dvec3 du = t[1] + p.y * t[4] + p.z * (t[6] + p.y * t[7]);
    const dvec3 dv = t[2] + p.x * t[4] + p.z * (t[5] + p.x * t[7]);
    const dvec3 dw = t[3] + p.y * t[5] + p.x * (t[6] + p.y * t[7]);
    dvec3 miss = -(t[0] + p.x * du + p.y * (t[2] + p.z * t[5]) + p.z * t[3]);
    miss.z += depth;
    const dvec3 across = cross(dv, dw);
    const double volume = dot(du, across);
    const dvec3 step =
      dvec3(dot(across, miss), dot(cross(dw, du), miss), dot(cross(du, dv), miss)) / volume;
    p += step;
    const double size = dot(step, step);
    if (!(size < 1.0)) // also NaN
    {
      return false;
    }
    if (size < LastStep)
    {
      const dvec3 outside = max(-p, p - 1.0);
      return std::max({ outside.x, outside.y, outside.z }) <= ParameterMargin;
    }
  }
  return false;
}

bool HexahedronCrossing::FindParameters(std::array<dvec3, 4>& parameters)
{
  this->FindTerms();
  const double length = this->Ends[1].Depth - this->Ends[0].Depth;
  const auto locate = [&](double depth, dvec3& found)
  {
    const double share = (depth - this->Ends[0].Depth) / length;
    found = mix(this->Ends[0].Parameters, this->Ends[1].Parameters, share);
    return this->Locate(depth, found);
  };
  parameters[0] = this->Ends[0].Parameters;
  parameters[3] = this->Ends[1].Parameters;
  return (this->Begin == this->Ends[0].Depth || locate(this->Begin, parameters[0])) &&
    locate(this->Begin + (this->End - this->Begin) / 3.0, parameters[1]) &&
    locate(this->End - (this->End - this->Begin) / 3.0, parameters[2]) &&
    (this->End == this->Ends[1].Depth || locate(this->End, parameters[3]));
}

double HexahedronCrossing::Interpolate(const std::array<double, NumberOfCorners>& s, const dvec3& p)
{
  const double low = mix(mix(s[0], s[1], p.x), mix(s[3], s[2], p.x), p.y);
  const double high = mix(mix(s[4], s[5], p.x), mix(s[7], s[6], p.x), p.y);
  return mix(low, high, p.z);
}
}

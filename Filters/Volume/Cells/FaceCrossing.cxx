// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/FaceCrossing.h"

#include "Integral/AcrossRay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// In parameters. Hits slightly outside of the face are accepted.
constexpr double Margin = 1e-6;
// Triangles of 1/2^12 of a face have at most one hit, which Newton's method finds.
constexpr int DeepestFaceSplit = 12;

double Cross2(const dvec2& a, const dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

bool IsShare(double u)
{
  return u >= -Margin && u <= 1.0 + Margin;
}

// A quadratic triangle in ray coordinates: two perpendicular axes and the distance.
struct SeenTriangle
{
  std::array<dvec3, 6> Points;

  // Evaluates the triangle at barycentric coordinates.
  dvec3 At(const dvec3& w) const
  {
    dvec3 point(0.0);
    for (int i = 0; i < 3; ++i)
    {
      point += w[i] * (2.0 * w[i] - 1.0) * this->Points[i];
      point += 4.0 * w[i] * w[(i + 1) % 3] * this->Points[3 + i];
    }
    return point;
  }

  // Refines a hit with Newton's method, starting inside of a small triangle.
  bool Polish(dvec3& w) const
  {
    for (int i = 0; i < 8; ++i)
    {
      const dvec2 miss(this->At(w));
      // Central differences are exact for a quadratic function.
      const double step = 0.25;
      const dvec2 du = (dvec2(this->At(w + step * dvec3(-1.0, 1.0, 0.0))) -
                         dvec2(this->At(w - step * dvec3(-1.0, 1.0, 0.0)))) /
        (2.0 * step);
      const dvec2 dv = (dvec2(this->At(w + step * dvec3(-1.0, 0.0, 1.0))) -
                         dvec2(this->At(w - step * dvec3(-1.0, 0.0, 1.0)))) /
        (2.0 * step);
      const double area = Cross2(du, dv);
      if (area == 0.0)
      {
        return false;
      }
      const double u = -Cross2(miss, dv) / area;
      const double v = -Cross2(du, miss) / area;
      w += dvec3(-u - v, u, v);
    }
    return std::isfinite(w.x + w.y + w.z) && IsShare(w.x) && IsShare(w.y) && IsShare(w.z);
  }

  // Whether the bounding box of a sub-triangle's Bézier points contains the ray. The Bézier points
  // of its edges follow from the polar form of quadratics, f(a, b) = 2 P((a + b) / 2) - (P(a) +
  // P(b)) / 2.
  bool MayHit(const dmat3& part) const
  {
    dvec2 low(std::numeric_limits<double>::max());
    dvec2 high = -low;
    for (int i = 0; i < 3; ++i)
    {
      const dvec3& a = part[i];
      const dvec3& b = part[(i + 1) % 3];
      const dvec2 end(this->At(a));
      const dvec2 middle = 2.0 * dvec2(this->At(0.5 * (a + b))) - 0.5 * (end + dvec2(this->At(b)));
      low = min(low, min(end, middle));
      high = max(high, max(end, middle));
    }
    const dvec2 margin = Margin * (high - low);
    return low.x <= margin.x && low.y <= margin.y && high.x >= -margin.x && high.y >= -margin.y;
  }

  void Find(const dmat3& part, int depth, std::vector<double>& hits) const
  {
    if (!this->MayHit(part))
    {
      return;
    }
    if (depth == DeepestFaceSplit)
    {
      dvec3 w = (part[0] + part[1] + part[2]) / 3.0;
      if (this->Polish(w))
      {
        hits.push_back(this->At(w).z);
      }
      return;
    }
    const dvec3 a = 0.5 * (part[0] + part[1]);
    const dvec3 b = 0.5 * (part[1] + part[2]);
    const dvec3 c = 0.5 * (part[2] + part[0]);
    this->Find(dmat3(part[0], a, c), depth + 1, hits);
    this->Find(dmat3(part[1], b, a), depth + 1, hits);
    this->Find(dmat3(part[2], c, b), depth + 1, hits);
    this->Find(dmat3(a, b, c), depth + 1, hits);
  }
};
}

// In the plane perpendicular to the ray, the hit satisfies 0 = a + u b + v c + u v d. So a + v c
// and b + v d are parallel, which is a quadratic equation for v.
void CrossBilinearFace(
  const std::array<dvec3, 4>& corners, const Ray& ray, std::vector<double>& hits)
{
  const dvec3 from = corners[0] - ray.Origin;
  const dvec3 alongU = corners[1] - corners[0];
  const dvec3 alongV = corners[3] - corners[0];
  const dvec3 twist = corners[2] - corners[1] - alongV;
  const AcrossRay across(ray.Direction);
  const dvec2 a = across(from);
  const dvec2 b = across(alongU);
  const dvec2 c = across(alongV);
  const dvec2 d = across(twist);
  const double square = Cross2(c, d);
  const double linear = Cross2(a, d) + Cross2(c, b);
  const double constant = Cross2(a, b);
  const double discriminant = std::max(linear * linear - 4.0 * square * constant, 0.0);
  const double q = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
  for (const double v : { q / square, constant / q })
  {
    const dvec2 way = b + v * d;
    const double u = -dot(a + v * c, way) / dot(way, way);
    if (IsShare(u) && IsShare(v)) // false for NaN
    {
      hits.push_back(dot(from + u * alongU + v * alongV + u * v * twist, ray.Direction));
    }
  }
}

void CrossQuadraticFace(
  const std::array<dvec3, 6>& points, const Ray& ray, std::vector<double>& hits)
{
  const AcrossRay across(ray.Direction);
  SeenTriangle seen;
  for (size_t i = 0; i < points.size(); ++i)
  {
    const dvec3 from = points[i] - ray.Origin;
    seen.Points[i] = dvec3(across(from), dot(from, ray.Direction));
  }
  seen.Find(dmat3(1.0), 0, hits);
}
}

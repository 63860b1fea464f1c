// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/BezierFaceCrossing.h"

#include "Integral/AcrossRay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// In parameters of a part. Hits slightly outside of the face are accepted.
constexpr double FaceMargin = 1e-7;
constexpr double EdgeOn = 1e-12; // width of a face, relative to its size
constexpr int MostHalvings = 24; // in both directions together

double Cross2(const dvec2& a, const dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// A rational Bézier patch in ray coordinates, times weights: two perpendicular axes, the distance
// and the weight. The ray hits it where the first two are 0.
class SeenPatch
{
public:
  int DegreeU;
  int DegreeV;
  std::array<dvec4, (LargestDegree + 1) * (LargestDegree + 1)> Points;

  dvec4& At(int i, int j) { return this->Points[static_cast<size_t>(j * (DegreeU + 1) + i)]; }
  const dvec4& At(int i, int j) const
  {
    return this->Points[static_cast<size_t>(j * (DegreeU + 1) + i)];
  }

  /// Whether the ray sees the patch edge-on, so that it has no area.
  bool IsEdgeOn() const;
  void Find(int halvings, std::vector<double>& hits) const;

private:
  bool MayHit() const;
  bool IsRegular(bool& splitsU) const;
  bool Solve(std::vector<double>& hits) const;
  void Evaluate(const dvec2& at, dvec4& value, dvec4& byU, dvec4& byV) const;
  void Halve(bool isU, SeenPatch& low, SeenPatch& high) const;
};

bool SeenPatch::IsEdgeOn() const
{
  const int count = (this->DegreeU + 1) * (this->DegreeV + 1);
  const auto get = [this](int i)
  {
    const dvec4& point = this->Points[static_cast<size_t>(i)];
    return dvec3(point) / point.w;
  };
  const dvec3 first = get(0);
  dvec2 farthest(0.0);
  double size = 0.0;
  for (int i = 1; i < count; ++i)
  {
    const dvec3 way = get(i) - first;
    size = std::max(size, length(way));
    farthest = length(dvec2(way)) > length(farthest) ? dvec2(way) : farthest;
  }
  double width = 0.0;
  for (int i = 1; i < count && length(farthest) > 0.0; ++i)
  {
    width = std::max(width, std::abs(Cross2(dvec2(get(i) - first), normalize(farthest))));
  }
  return width <= EdgeOn * size;
}

bool SeenPatch::MayHit() const
{
  dvec2 low(std::numeric_limits<double>::max());
  dvec2 high = -low;
  for (int i = 0; i < (this->DegreeU + 1) * (this->DegreeV + 1); ++i)
  {
    const dvec2 point(this->Points[static_cast<size_t>(i)]);
    low = min(low, point);
    high = max(high, point);
  }
  const dvec2 margin = FaceMargin * (high - low);
  return low.x <= margin.x && low.y <= margin.y && high.x >= -margin.x && high.y >= -margin.y;
}

// Returns whether the map to the plane across the ray is one-to-one, because the derivatives differ
// too little from their means. Otherwise finds the direction to halve.
bool SeenPatch::IsRegular(bool& splitsU) const
{
  dvec2 u(0.0);
  dvec2 v(0.0);
  for (int j = 0; j <= this->DegreeV; ++j)
  {
    u += dvec2(this->At(this->DegreeU, j) - this->At(0, j)) / (this->DegreeV + 1.0);
  }
  for (int i = 0; i <= this->DegreeU; ++i)
  {
    v += dvec2(this->At(i, this->DegreeV) - this->At(i, 0)) / (this->DegreeU + 1.0);
  }
  double offU = 0.0;
  double offV = 0.0;
  for (int j = 0; j <= this->DegreeV; ++j)
  {
    for (int i = 0; i <= this->DegreeU; ++i)
    {
      if (i < this->DegreeU)
      {
        offU = std::max(offU,
          length(
            static_cast<double>(this->DegreeU) * dvec2(this->At(i + 1, j) - this->At(i, j)) - u));
      }
      if (j < this->DegreeV)
      {
        offV = std::max(offV,
          length(
            static_cast<double>(this->DegreeV) * dvec2(this->At(i, j + 1) - this->At(i, j)) - v));
      }
    }
  }
  splitsU = this->DegreeV == 0 || length(u) + offU > length(v) + offV;
  return std::abs(Cross2(u, v)) > length(u) * offV + length(v) * offU + offU * offV;
}

void SeenPatch::Evaluate(const dvec2& at, dvec4& value, dvec4& byU, dvec4& byV) const
{
  // De Casteljau's algorithm, along u and then along v.
  std::array<dvec4, LargestDegree + 1> points;
  std::array<dvec4, LargestDegree + 1> slopes;
  for (int j = 0; j <= this->DegreeV; ++j)
  {
    std::array<dvec4, LargestDegree + 1> row;
    std::copy_n(&this->At(0, j), this->DegreeU + 1, row.begin());
    for (int n = this->DegreeU; n > 1; --n)
    {
      for (int i = 0; i < n; ++i)
      {
        row[i] = mix(row[i], row[i + 1], at.x);
      }
    }
    slopes[j] = static_cast<double>(this->DegreeU) * (row[1] - row[0]);
    points[j] = mix(row[0], row[1], at.x);
  }
  for (int n = this->DegreeV; n > 1; --n)
  {
    for (int j = 0; j < n; ++j)
    {
      points[j] = mix(points[j], points[j + 1], at.y);
      slopes[j] = mix(slopes[j], slopes[j + 1], at.y);
    }
  }
  byV = static_cast<double>(this->DegreeV) * (points[1] - points[0]);
  value = mix(points[0], points[1], at.y);
  byU = mix(slopes[0], slopes[1], at.y);
}

// Returns whether Newton's method converges, inside or outside of the patch.
bool SeenPatch::Solve(std::vector<double>& hits) const
{
  dvec2 at(0.5);
  for (int i = 0; i < 20; ++i)
  {
    dvec4 value;
    dvec4 byU;
    dvec4 byV;
    this->Evaluate(at, value, byU, byV);
    const dvec2 u(byU);
    const dvec2 v(byV);
    const double area = Cross2(u, v);
    if (area == 0.0)
    {
      return false;
    }
    const dvec2 step(-Cross2(dvec2(value), v) / area, -Cross2(u, dvec2(value)) / area);
    at += step;
    if (!(std::abs(at.x - 0.5) < 2.0 && std::abs(at.y - 0.5) < 2.0))
    {
      return false;
    }
    if (dot(step, step) < 1e-28)
    {
      this->Evaluate(at, value, byU, byV);
      const double outside = std::max(std::abs(at.x - 0.5), std::abs(at.y - 0.5)) - 0.5;
      if (outside <= FaceMargin)
      {
        hits.push_back(value.z / value.w);
      }
      return true;
    }
  }
  return false;
}

void SeenPatch::Halve(bool isU, SeenPatch& low, SeenPatch& high) const
{
  low = high = *this;
  const int degree = isU ? this->DegreeU : this->DegreeV;
  const int others = isU ? this->DegreeV : this->DegreeU;
  for (int k = 0; k <= others; ++k)
  {
    const auto get = [&](SeenPatch& patch, int i) -> dvec4&
    { return isU ? patch.At(i, k) : patch.At(k, i); };
    for (int n = degree; n > 0; --n)
    {
      get(low, degree - n) = get(high, 0);
      for (int i = 0; i < n; ++i)
      {
        get(high, i) = 0.5 * (get(high, i) + get(high, i + 1));
      }
    }
    get(low, degree) = get(high, 0);
  }
}

void SeenPatch::Find(int halvings, std::vector<double>& hits) const
{
  if (!this->MayHit())
  {
    return;
  }
  bool isU;
  const bool isRegular = this->IsRegular(isU);
  if ((isRegular || halvings == MostHalvings) && (this->Solve(hits) || halvings == MostHalvings))
  {
    return;
  }
  SeenPatch low;
  SeenPatch high;
  this->Halve(isU, low, high);
  low.Find(halvings + 1, hits);
  high.Find(halvings + 1, hits);
}
}

void CrossBezierFace(
  const BezierHexahedron& shape, int face, const Ray& ray, std::vector<double>& hits)
{
  const int direction = face / 2;
  const int u = (direction + 1) % 3;
  const int v = (direction + 2) % 3;
  const ivec3 degrees = shape.GetDegrees();
  const AcrossRay across(ray.Direction);
  SeenPatch patch;
  patch.DegreeU = degrees[u];
  patch.DegreeV = degrees[v];
  ivec3 at;
  at[direction] = face % 2 == 0 ? 0 : degrees[direction];
  for (int j = 0; j <= degrees[v]; ++j)
  {
    for (int i = 0; i <= degrees[u]; ++i)
    {
      at[u] = i;
      at[v] = j;
      const double* point = shape.GetCoefficient(shape.GetIndex(at.x, at.y, at.z));
      const dvec3 from = dvec3(point[0], point[1], point[2]) - point[3] * ray.Origin;
      patch.At(i, j) = dvec4(across(from), dot(from, ray.Direction), point[3]);
    }
  }
  if (!patch.IsEdgeOn())
  {
    patch.Find(0, hits);
  }
}
}

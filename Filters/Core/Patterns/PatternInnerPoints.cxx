// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternInnerPoints.h"

#include "Patterns/PatternBorder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace
{
using namespace relevo;

// Percentages and angles below are for all patterns of levels 0 to 7 together.

/// The growth of the distance between points with the distance from a finer edge. A value of 0.2
/// gives 26 % more triangles but no larger smallest angles. A value of 0.6 gives 80 % more
/// triangles with an angle below 30 degrees.
constexpr double Gradation = 0.3;

/// The smallest distance of grid points from other points, relative to the size field. Values from
/// 0.6 to 0.8 give the same smallest angles. A value of 0.9 gives 35 % fewer triangles, but
/// patterns across one level fall from 30 to 19 degrees.
constexpr double Separation = 0.72;

/// The smallest distance for the tips of fans, which are close to each other by construction. A
/// value of 0.4 skips some, and the smallest angle across seven levels falls from 8.2 to 7.0
/// degrees.
constexpr double TipSeparation = 0.25;

/// A regular grid is used up to sizes of sqrt(2) times its spacing. The next grid, with about twice
/// the spacing, follows.
constexpr double LargestSpacingRatio = 1.42;

/// The highest number of sectors of a corner's fan, which is the number of doublings on the finest
/// edge.
constexpr int MaximumNumberOfSectors = 7;
static_assert(MaximumNumberOfSegments == 1 << MaximumNumberOfSectors);

/// 2 cos(60 degrees / k). std::cos may differ between machines.
constexpr double TwoCosines[MaximumNumberOfSectors + 1] = { 0.0, 1.0, 1.7320508075688772,
  1.8793852415718169, 1.9318516525781366, 1.9562952014676114, 1.9696155060244161,
  1.9776616524502590 };

/// The distance between neighbouring inner points, computed from the border.
class SizeField
{
public:
  explicit SizeField(const int segments[3])
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      this->Length[edge] = 1.0 / segments[edge];
    }
  }

  /// The size is the segment length near an edge. Inside, it is the mean of these lengths weighted
  /// by inverse distances, limited by the gradation.
  double operator()(PatternPoint p) const
  {
    const double v = static_cast<double>(p.V) / GridScale;
    const double w = static_cast<double>(p.W) / GridScale;
    const double u = 1.0 - v - w;
    const double heights[3] = { w, u, v };             // above edges 1, 2, 3
    const double weights[3] = { u * v, v * w, w * u }; // 1 / height, times u v w
    double size =
      (weights[0] * this->Length[0] + weights[1] * this->Length[1] + weights[2] * this->Length[2]) /
      (weights[0] + weights[1] + weights[2]);
    for (int edge = 0; edge < 3; ++edge)
    {
      size = std::min(size, this->Length[edge] + Gradation * TriangleHeight * heights[edge]);
    }
    return size;
  }

private:
  double Length[3];
};

/// Points in buckets, for neighbourhood queries.
class PointBuckets
{
public:
  explicit PointBuckets(int resolution)
    : Resolution(resolution)
    , Buckets(static_cast<std::size_t>(resolution) * resolution)
  {
  }

  void Add(PatternPoint p)
  {
    this->Buckets[this->Bucket(p.W) * this->Resolution + this->Bucket(p.V)].push_back(p);
  }

  /// Whether a point is nearer to p than a distance (in units of the triangle's side).
  bool IsNear(PatternPoint p, double distance) const
  {
    const double limit = distance * GridScale;
    const double squaredLimit = limit * limit;
    const std::int64_t reach =
      static_cast<std::int64_t>(limit / TriangleHeight) + 1; // in terms of a weight
    for (int j = this->Bucket(p.W - reach); j <= this->Bucket(p.W + reach); ++j)
    {
      for (int i = this->Bucket(p.V - reach); i <= this->Bucket(p.V + reach); ++i)
      {
        for (const PatternPoint& q : this->Buckets[j * this->Resolution + i])
        {
          if (static_cast<double>(SquaredLength(p - q)) < squaredLimit)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  int Bucket(std::int64_t weight) const
  {
    weight = std::min(std::max<std::int64_t>(weight, 0), GridScale - 1);
    return static_cast<int>(weight * this->Resolution / GridScale);
  }

  int Resolution;
  std::vector<std::vector<PatternPoint>> Buckets;
};

/// The nearest allowed position of an inner point.
PatternPoint Snapped(double v, double w)
{
  const double steps = static_cast<double>(GridScale / InnerStep);
  return { static_cast<std::int64_t>(std::floor(v * steps + 0.5)) * InnerStep,
    static_cast<std::int64_t>(std::floor(w * steps + 0.5)) * InnerStep };
}

bool IsInside(PatternPoint p)
{
  return p.V > 0 && p.W > 0 && p.V + p.W < GridScale;
}

/// The k-th root of x >= 1, computed by Newton's method from above. std::pow may differ between
/// machines.
double Root(double x, int k)
{
  double root = x;
  for (;;)
  {
    double power = 1.0;
    for (int i = 1; i < k; ++i)
    {
      power *= root;
    }
    const double next = root - (root - x / power) / k;
    if (!(next < root))
    {
      return root;
    }
    root = next;
  }
}

/// The triangles at a corner where a fine and a coarse edge meet. Spokes from the corner divide its
/// 60 degrees into equal sectors. Each spoke is about twice as long as the previous one. The
/// smallest angle is then close to the largest that the two edges allow.
class CornerFan
{
public:
  CornerFan(const int segments[3], int corner)
  {
    const int next = (corner + 1) % 3;
    const int previous = (corner + 2) % 3;
    const bool startsFine = segments[corner] >= segments[previous];
    const int fineEnd = startsFine ? next : previous;
    const int coarseEnd = startsFine ? previous : next;
    const int fine = std::max(segments[corner], segments[previous]);
    const int coarse = std::min(segments[corner], segments[previous]);
    const double ratio = static_cast<double>(fine) / coarse;
    int sectors = 1; // log2(ratio), rounded
    while (ratio * ratio > (2 << (2 * sectors)))
    {
      ++sectors;
    }
    // sines[s] = sin(s 60 / sectors) / sin(60 / sectors).
    double sines[MaximumNumberOfSectors + 1] = { 0.0, 1.0 };
    for (int s = 2; s <= sectors; ++s)
    {
      sines[s] = TwoCosines[sectors] * sines[s - 1] - sines[s - 2];
    }
    const double growth = Root(ratio, sectors);
    double length = 1.0 / fine;
    for (int s = 0; s <= sectors; ++s)
    {
      double weights[3];
      weights[fineEnd] = length * sines[sectors - s] / sines[sectors];
      weights[coarseEnd] = length * sines[s] / sines[sectors];
      weights[corner] = 1.0 - weights[fineEnd] - weights[coarseEnd];
      this->Tips.push_back(Snapped(weights[1], weights[2]));
      length *= growth;
    }
    if (!startsFine)
    {
      std::reverse(this->Tips.begin(), this->Tips.end());
    }
    this->Corner = { corner == 1 ? GridScale : 0, corner == 2 ? GridScale : 0 };
  }

  bool Contains(PatternPoint p) const
  {
    for (std::size_t s = 1; s < this->Tips.size(); ++s)
    {
      const PatternPoint& a = this->Tips[s - 1];
      const PatternPoint& b = this->Tips[s];
      if (Orientation(this->Corner, a, p) >= 0 && Orientation(this->Corner, b, p) <= 0 &&
        Orientation(a, b, p) >= 0)
      {
        return true;
      }
    }
    return false;
  }

  /// Ends of the spokes, counter-clockwise. The first and the last are on the edges.
  std::vector<PatternPoint> Tips;

private:
  PatternPoint Corner;
};
}

namespace relevo
{
std::vector<PatternPoint> MakeInnerPoints(
  const int segments[3], const std::vector<PatternPoint>& border)
{
  const SizeField size(segments);
  PointBuckets buckets(segments[0]);
  for (const PatternPoint& p : border)
  {
    buckets.Add(p);
  }
  std::vector<CornerFan> fans;
  std::vector<PatternPoint> points;
  auto accept = [&](PatternPoint p, double distance)
  {
    if (IsInside(p) && !buckets.IsNear(p, distance))
    {
      buckets.Add(p);
      points.push_back(p);
    }
  };
  for (int corner = 0; corner < 3; ++corner)
  {
    if (segments[corner] != segments[(corner + 2) % 3])
    {
      fans.emplace_back(segments, corner);
      for (const PatternPoint& p : fans.back().Tips)
      {
        accept(p, TipSeparation * size(p));
      }
    }
  }
  auto isInFan = [&](PatternPoint p)
  {
    return std::any_of(
      fans.begin(), fans.end(), [&](const CornerFan& fan) { return fan.Contains(p); });
  };
  // No size is smaller than the spacing of the first grid.
  for (int n = segments[0]; n > 1; n = (n + 1) / 2)
  {
    const double spacing = 1.0 / n;
    for (int j = 1; j < n; ++j)
    {
      for (int i = 1; i + j < n; ++i)
      {
        const PatternPoint p = Snapped(i * spacing, j * spacing);
        const double h = size(p);
        const bool isRightGrid =
          h < LargestSpacingRatio * spacing && h >= 0.5 * LargestSpacingRatio * spacing;
        if (isRightGrid && !isInFan(p))
        {
          accept(p, Separation * h);
        }
      }
    }
  }
  return points;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternWalk
 * @brief   visits the points of a pattern where the deviation from a height map can be largest
 *
 * The sampler has types Vertex, with Place (in texels from the first centre) and operators + and *,
 * and Value. Its Evaluate(vertex) returns the deviation.
 */
#ifndef PatternWalk_h
#define PatternWalk_h

#include "Mathematics/RefinementMathematics.h"
#include "Surfaces/HeightSampler.h"

#include <algorithm> // for sort
#include <cmath>     // for floor
#include <vector>    // for members

namespace relevo
{
inline double GetLength(double value)
{
  return std::abs(value);
}
inline double GetLength(const dvec3& value)
{
  return length(value);
}
inline double GetComponent(double value, int)
{
  return value;
}
inline double GetComponent(const dvec3& value, int component)
{
  return value[component];
}
constexpr int CountComponents(double)
{
  return 1;
}
inline int CountComponents(const dvec3&)
{
  return 3;
}

/// The largest length of a quadratic function with values at 0, 1/2 and 1, at its ends and where a
/// component is extreme.
template <typename Value>
double GetLargest(const Value& first, const Value& middle, const Value& last)
{
  double largest = std::max({ GetLength(first), GetLength(middle), GetLength(last) });
  const Value square = 2.0 * (first + last) - 4.0 * middle;
  const Value slope = 4.0 * middle - 3.0 * first - last;
  for (int c = 0; c < CountComponents(first); ++c)
  {
    const double s = -0.5 * GetComponent(slope, c) / GetComponent(square, c);
    if (s > 0.0 && s < 1.0)
    {
      largest = std::max(largest, GetLength(first + slope * s + square * (s * s)));
    }
  }
  return largest;
}

template <typename Sampler>
class PatternWalk
{
public:
  using Vertex = typename Sampler::Vertex;
  using Value = typename Sampler::Value;

  PatternWalk(const Sampler& sampler, const HeightSampler& heights)
    : Samples(sampler)
    , Heights(heights)
    , Last(dvec2(heights.heightSize()) - 1.0)
  {
  }

  /// The largest deviation on a line of at least this number of parts.
  double MeasureLine(const Vertex& a, const Vertex& b, int parts)
  {
    this->FindCuts(a, b, parts);
    double largest = 0.0;
    double begin = 0.0;
    Value first = this->Samples.Evaluate(a);
    for (double end : this->Cuts)
    {
      const Value last = this->Samples.Evaluate(Mix(a, b, end));
      const Vertex middle = Mix(a, b, 0.5 * (begin + end));
      if (end > begin && this->IsValid(middle.Place))
      {
        largest = std::max(largest, GetLargest(first, this->Samples.Evaluate(middle), last));
      }
      first = last;
      begin = end;
    }
    return largest;
  }

  /// Calls f(shares) with the shares of the corners at each valid texel centre inside a triangle.
  template <typename Function>
  void ForEachTexel(const Vertex& a, const Vertex& b, const Vertex& c, Function&& f) const
  {
    const dvec2 p = b.Place - a.Place;
    const dvec2 q = c.Place - a.Place;
    const double area = p.x * q.y - p.y * q.x;
    const dvec2 low = max(ceil(min(min(a.Place, b.Place), c.Place)), dvec2(0.0));
    const dvec2 high = min(floor(max(max(a.Place, b.Place), c.Place)), this->Last);
    if (area == 0.0)
    {
      return;
    }
    for (double y = low.y; y <= high.y; y += 1.0)
    {
      // The shares of b and c are linear along a row.
      const double offset = y - a.Place.y;
      const dvec2 start(-offset * q.x / area, offset * p.x / area);
      const dvec2 step(q.y / area, -p.y / area);
      dvec2 range(low.x, high.x);
      Clip(range, a.Place.x, start.x, step.x);
      Clip(range, a.Place.x, start.y, step.y);
      Clip(range, a.Place.x, 1.0 - start.x - start.y, -step.x - step.y);
      for (double x = std::ceil(range.x); x <= range.y; x += 1.0)
      {
        if (this->Heights.validTexel(ivec2(x, y)) > 0.0f)
        {
          const dvec2 shares = start + step * (x - a.Place.x);
          f(dvec3(1.0 - shares.x - shares.y, shares.x, shares.y));
        }
      }
    }
  }

  /// The largest deviation at the texel centres inside a triangle.
  double MeasureTexels(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    double largest = 0.0;
    this->ForEachTexel(a, b, c,
      [&](const dvec3& shares)
      {
        const Vertex vertex = a * shares.x + b * shares.y + c * shares.z;
        largest = std::max(largest, GetLength(this->Samples.Evaluate(vertex)));
      });
    return largest;
  }

  /// The largest deviation at the points that divide the sides of a triangle into parts.
  double MeasureLattice(const Vertex& a, const Vertex& b, const Vertex& c, int parts) const
  {
    double largest = 0.0;
    for (int i = 0; i <= parts; ++i)
    {
      for (int j = 0; i + j <= parts; ++j)
      {
        const double whole = parts;
        const Vertex vertex = a * (i / whole) + b * (j / whole) + c * ((parts - i - j) / whole);
        if (this->IsValid(vertex.Place))
        {
          largest = std::max(largest, GetLength(this->Samples.Evaluate(vertex)));
        }
      }
    }
    return largest;
  }

private:
  static Vertex Mix(const Vertex& a, const Vertex& b, double s) { return a * (1.0 - s) + b * s; }

  // Reduces a range of x to where start + step (x - origin) is not negative.
  static void Clip(dvec2& range, double origin, double start, double step)
  {
    const double x = origin - start / step;
    if (step > 0.0)
    {
      range.x = std::max(range.x, x);
    }
    else if (step < 0.0)
    {
      range.y = std::min(range.y, x);
    }
    else if (start < 0.0)
    {
      range.y = range.x - 1.0;
    }
  }

  void AddCuts(double from, double to, double last)
  {
    const double low = std::max(std::ceil(std::min(from, to)), 0.0);
    const double high = std::min(std::floor(std::max(from, to)), last);
    for (double line = low; line <= high; line += 1.0)
    {
      const double s = (line - from) / (to - from);
      if (s > 0.0 && s < 1.0)
      {
        this->Cuts.push_back(s);
      }
    }
  }

  void FindCuts(const Vertex& a, const Vertex& b, int parts)
  {
    this->Cuts.clear();
    this->AddCuts(a.Place.x, b.Place.x, this->Last.x);
    this->AddCuts(a.Place.y, b.Place.y, this->Last.y);
    for (int k = 1; k <= parts; ++k)
    {
      this->Cuts.push_back(static_cast<double>(k) / parts);
    }
    std::sort(this->Cuts.begin(), this->Cuts.end());
  }

  // Whether the cell at a place has no missing sample.
  bool IsValid(const dvec2& place) const
  {
    if (!this->Heights.Validity)
    {
      return true;
    }
    const dvec2 inside = clamp(place, dvec2(0.0), this->Last);
    const ivec2 low(floor(inside));
    const ivec2 high(ceil(inside));
    return this->Heights.validTexel(low) * this->Heights.validTexel(ivec2(high.x, low.y)) *
      this->Heights.validTexel(ivec2(low.x, high.y)) * this->Heights.validTexel(high) >
      0.0f;
  }

  const Sampler& Samples;
  const HeightSampler& Heights;
  const dvec2 Last;
  std::vector<double> Cuts;
};
}

#endif

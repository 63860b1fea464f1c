// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Distance/DistanceBound.h"

#include "Distance/SegmentDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double Unbounded = std::numeric_limits<double>::infinity();
// Lengths relative to the tolerance: sides of parts and of triangles that are not bisected any
// more, those of triangles that are often within the tolerance of one triangle, and the distance
// of negligible parts from others.
constexpr double ShortestSide = 1.0 / 8.0;
constexpr double ShortestHalf = 2.0;
constexpr double SmallSide = 4.0;
constexpr double NegligibleWidth = 1e-6;
// Triangles with more triangles of the surface near them are bisected first.
constexpr std::size_t MostNear = 40;
constexpr std::size_t MostParts = 80;
// The smallest cosine between normals for which a triangle covers another.
constexpr double LeastCosine = 0.05;

double GetSide2(const dvec3& a, const dvec3& b)
{
  return dot(b - a, b - a);
}

// Returns the edge with the largest length and its square.
int FindLongestEdge(const DistanceBound::Corners& corners, double& length2)
{
  length2 = -1.0;
  int edge = 0;
  for (int e = 0; e < 3; ++e)
  {
    const double side2 = GetSide2(
      corners[static_cast<std::size_t>(e)], corners[static_cast<std::size_t>((e + 1) % 3)]);
    if (side2 > length2)
    {
      length2 = side2;
      edge = e;
    }
  }
  return edge;
}

double Cross(const dvec2& a, const dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}
}

bool DistanceBound::FindCandidates(const Corners& triangle, std::size_t most)
{
  FloatBox box;
  for (const dvec3& corner : triangle)
  {
    const vec3 point(corner);
    box.Add(&point.x);
  }
  const auto margin = static_cast<float>(this->Tolerance);
  for (std::size_t c = 0; c < 3; ++c)
  {
    box.Low[c] -= margin;
    box.High[c] += margin;
  }
  this->Near.clear();
  this->Surface.VisitIntersecting(box,
    [&](int candidate)
    {
      this->Near.push_back(candidate);
      return this->Near.size() <= most;
    });
  return this->Near.size() <= most;
}

DistanceBound::Corner DistanceBound::FindCorner(const dvec3& point, int guess) const
{
  double distance2 = this->Tolerance * this->Tolerance;
  int nearest = -1;
  if (guess >= 0)
  {
    const double guessed = this->Surface.GetDistance2(point, guess);
    if (guessed <= distance2)
    {
      distance2 = guessed;
      nearest = guess;
    }
  }
  this->Surface.FindNearest(point, distance2, nearest);
  return { point, nearest };
}

bool DistanceBound::IsSmall(const Corners& triangle) const
{
  double longest2;
  FindLongestEdge(triangle, longest2);
  return longest2 <= SmallSide * SmallSide * this->Tolerance * this->Tolerance;
}

double DistanceBound::FindBoundOfHalves(const Corners& triangle, int edge)
{
  const auto first = static_cast<std::size_t>(edge);
  const std::size_t second = (first + 1) % 3;
  const dvec3 middle = 0.5 * (triangle[first] + triangle[second]);
  double bound = 0.0;
  for (std::size_t moved : { second, first })
  {
    Corners half = triangle;
    half[moved] = middle;
    if (bound < Unbounded && this->IsSmall(half))
    {
      const Corner a = this->FindCorner(half[0]);
      const Corner b = this->FindCorner(half[1], a.Nearest);
      bound = std::max(bound, this->Find(a, b, this->FindCorner(half[2], b.Nearest)));
    }
    else if (bound < Unbounded)
    {
      bound = std::max(bound, this->Find(half));
    }
  }
  return bound;
}

double DistanceBound::Find(const Corner& a, const Corner& b, const Corner& c)
{
  if (a.Nearest < 0 || b.Nearest < 0 || c.Nearest < 0)
  {
    return Unbounded;
  }
  double bound2 = Unbounded;
  for (int nearest : { a.Nearest, b.Nearest, c.Nearest })
  {
    bound2 = std::min(bound2,
      std::max({ this->Surface.GetDistance2(a.Point, nearest),
        this->Surface.GetDistance2(b.Point, nearest),
        this->Surface.GetDistance2(c.Point, nearest) }));
    if (bound2 <= this->Tolerance * this->Tolerance)
    {
      return std::sqrt(bound2);
    }
  }
  return this->Find({ { a.Point, b.Point, c.Point } });
}

double DistanceBound::Find(const Corners& triangle)
{
  double longest2;
  const int edge = FindLongestEdge(triangle, longest2);
  const double shortest = ShortestHalf * this->Tolerance;
  const bool canHalve = longest2 > shortest * shortest;
  if (!this->FindCandidates(
        triangle, canHalve ? MostNear : std::numeric_limits<std::size_t>::max()))
  {
    return this->FindBoundOfHalves(triangle, edge);
  }
  if (this->Near.empty())
  {
    return Unbounded;
  }
  const dvec3 along = triangle[1] - triangle[0];
  const dvec3 normal = cross(along, triangle[2] - triangle[0]);
  const double size = length(normal);
  this->Bound = 0.0;
  this->Parts.clear();
  if (!(size > this->Tolerance * NegligibleWidth * std::sqrt(longest2)))
  {
    this->Candidates.clear();
    return this->Bisect(triangle, 0); // almost a line
  }
  Frame frame;
  frame.Origin = triangle[0];
  frame.Normal = normal / size;
  frame.U = along / length(along);
  frame.V = cross(frame.Normal, frame.U);
  this->Parts.emplace_back();
  for (const dvec3& corner : triangle)
  {
    const dvec3 offset = corner - frame.Origin;
    this->Parts[0].Add(dvec2(dot(frame.U, offset), dot(frame.V, offset)));
  }
  this->Low = this->High = this->Parts[0].Points[0];
  for (std::size_t i = 1; i < 3; ++i)
  {
    this->Low = min(this->Low, this->Parts[0].Points[i]);
    this->High = max(this->High, this->Parts[0].Points[i]);
  }
  for (std::size_t i = 0; i < this->Near.size() && !this->Parts.empty(); ++i)
  {
    this->Cover(frame, this->Near[i]);
    if (this->Parts.size() > MostParts && canHalve)
    {
      return this->FindBoundOfHalves(triangle, edge);
    }
  }
  double bound = this->Bound;
  for (std::size_t i = 0; i < this->Parts.size() && bound < Unbounded; ++i)
  {
    bound = std::max(bound, this->FindBoundOfRest(frame, this->Parts[i]));
  }
  return bound;
}

bool DistanceBound::IsNegligible(const Polygon& polygon) const
{
  double area = 0.0;
  double longest2 = 0.0;
  for (std::size_t i = 1; i < polygon.Size; ++i)
  {
    const dvec2 offset = polygon.Points[i] - polygon.Points[0];
    longest2 = std::max(longest2, dot(offset, offset));
    if (i > 1)
    {
      area += Cross(polygon.Points[i - 1] - polygon.Points[0], offset);
    }
  }
  return area <= NegligibleWidth * this->Tolerance * std::sqrt(longest2);
}

// Whether all points of a polygon are at the side that it shares with another one. The tip of a
// narrow triangle is not, even if its area is negligible.
bool DistanceBound::IsNear(const Polygon& polygon, const Polygon& shared) const
{
  const double width = NegligibleWidth * this->Tolerance;
  for (std::size_t i = 0; i < polygon.Size; ++i)
  {
    if (shared.Size == 0 ||
      GetSegmentDistance2(polygon.Points[i], shared.Points[0], shared.Points[shared.Size - 1]) >
        width * width)
    {
      return false;
    }
  }
  return true;
}

// Cuts the points of all parts off that a triangle covers within the tolerance.
void DistanceBound::Cover(const Frame& frame, int candidate)
{
  std::array<dvec2, 3> corners;
  std::array<double, 3> heights;
  double lowest = Unbounded;
  double highest = -Unbounded;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const dvec3 offset = this->Surface.GetPoint(candidate, static_cast<int>(c)) - frame.Origin;
    corners[c] = dvec2(dot(frame.U, offset), dot(frame.V, offset));
    heights[c] = dot(frame.Normal, offset);
    lowest = std::min(lowest, heights[c]);
    highest = std::max(highest, heights[c]);
  }
  const double limit = this->Tolerance * (1.0 - 2.0 * NegligibleWidth);
  const dvec2 low = min(corners[0], min(corners[1], corners[2]));
  const dvec2 high = max(corners[0], max(corners[1], corners[2]));
  if (lowest > limit || highest < -limit || low.x > this->High.x || low.y > this->High.y ||
    high.x < this->Low.x || high.y < this->Low.y)
  {
    return;
  }
  const dvec2 one = corners[1] - corners[0];
  const dvec2 other = corners[2] - corners[0];
  const double area = Cross(one, other);
  const double rise = heights[1] - heights[0];
  const double otherRise = heights[2] - heights[0];
  const dvec2 slope = dvec2(rise * other.y - otherRise * one.y, otherRise * one.x - rise * other.x);
  // The slope is scaled by the area, so that the cosine of the normals is area / length.
  if (!(area > 0.0) || area * area < LeastCosine * LeastCosine * (area * area + dot(slope, slope)))
  {
    return;
  }
  for (std::size_t e = 0; e < 3; ++e)
  {
    const dvec2& from = corners[e];
    const dvec2 along = corners[(e + 1) % 3] - from;
    const dvec2 inward(-along.y, along.x);
    this->Planes[e] = { inward, -dot(inward, from) };
  }
  this->Height.Normal = slope / area;
  this->Height.Offset = heights[0] - dot(this->Height.Normal, corners[0]);
  std::size_t numberOfPlanes = 3;
  if (highest > limit || lowest < -limit)
  {
    this->Planes[3] = { -this->Height.Normal, limit - this->Height.Offset };
    this->Planes[4] = { this->Height.Normal, limit + this->Height.Offset };
    numberOfPlanes = 5;
  }
  this->NextParts.clear();
  for (const Polygon& part : this->Parts)
  {
    const std::size_t number = this->NextParts.size();
    if (!this->CutOff(part, numberOfPlanes))
    {
      this->NextParts.resize(number);
      this->NextParts.push_back(part);
    }
  }
  this->Parts.swap(this->NextParts);
}

// Appends what is left of a polygon without the intersection of half-planes. Returns false if the
// intersection is negligible or too complex.
bool DistanceBound::CutOff(const Polygon& polygon, std::size_t numberOfPlanes)
{
  Polygon rest = polygon;
  for (std::size_t p = 0; p < numberOfPlanes; ++p)
  {
    std::array<double, Polygon::MostPoints> values;
    bool isInside = true;
    bool isOutside = true;
    for (std::size_t i = 0; i < rest.Size; ++i)
    {
      values[i] = this->Planes[p].Evaluate(rest.Points[i]);
      isInside = isInside && values[i] >= 0.0;
      isOutside = isOutside && values[i] <= 0.0;
    }
    if (isOutside)
    {
      return false;
    }
    if (isInside)
    {
      continue;
    }
    if (rest.IsFull())
    {
      return false;
    }
    Polygon inner;
    Polygon outer;
    Polygon shared;
    for (std::size_t i = 0; i < rest.Size; ++i)
    {
      const std::size_t next = i + 1 == rest.Size ? 0 : i + 1;
      if (values[i] >= 0.0)
      {
        inner.Add(rest.Points[i]);
      }
      if (values[i] <= 0.0)
      {
        outer.Add(rest.Points[i]);
      }
      if (values[i] == 0.0)
      {
        shared.Add(rest.Points[i]);
      }
      if ((values[i] < 0.0 && values[next] > 0.0) || (values[i] > 0.0 && values[next] < 0.0))
      {
        if (inner.IsFull() || outer.IsFull())
        {
          return false;
        }
        const double share = values[i] / (values[i] - values[next]);
        const dvec2 point = rest.Points[i] + share * (rest.Points[next] - rest.Points[i]);
        inner.Add(point);
        outer.Add(point);
        shared.Add(point);
      }
    }
    if (!this->IsNear(outer, shared))
    {
      this->NextParts.push_back(outer);
    }
    rest = inner;
  }
  if (this->IsNegligible(rest))
  {
    return false;
  }
  const double width = 2.0 * NegligibleWidth * this->Tolerance;
  for (std::size_t i = 0; i < rest.Size; ++i)
  {
    this->Bound = std::max(this->Bound, std::abs(this->Height.Evaluate(rest.Points[i])) + width);
  }
  return true;
}

double DistanceBound::FindBoundOfRest(const Frame& frame, const Polygon& polygon)
{
  std::array<dvec3, Polygon::MostPoints> points;
  for (std::size_t i = 0; i < polygon.Size; ++i)
  {
    points[i] = frame.Origin + polygon.Points[i].x * frame.U + polygon.Points[i].y * frame.V;
  }
  double bound2 = Unbounded;
  for (int candidate : this->Near)
  {
    double farthest2 = 0.0;
    for (std::size_t i = 0; i < polygon.Size && farthest2 < bound2; ++i)
    {
      farthest2 = std::max(farthest2, this->Surface.GetDistance2(points[i], candidate));
    }
    bound2 = std::min(bound2, farthest2);
  }
  if (bound2 <= this->Tolerance * this->Tolerance)
  {
    return std::sqrt(bound2);
  }
  double bound = 0.0;
  for (std::size_t i = 2; i < polygon.Size && bound < Unbounded; ++i)
  {
    const Corners corners{ { points[0], points[i - 1], points[i] } };
    this->Candidates.clear();
    bound = std::max(bound, this->Bisect(corners, 0));
  }
  return bound;
}

// The candidates from `first` are those for these corners; if there are none, those near the
// triangle.
double DistanceBound::Bisect(const Corners& corners, std::size_t first)
{
  if (first == 0 && this->Candidates.empty())
  {
    for (int triangle : this->Near)
    {
      Candidate candidate{ triangle, {} };
      for (std::size_t c = 0; c < 3; ++c)
      {
        candidate.Distances[c] = std::sqrt(this->Surface.GetDistance2(corners[c], triangle));
      }
      this->Candidates.push_back(candidate);
    }
  }
  const std::size_t last = this->Candidates.size();
  double bound = Unbounded;
  std::array<double, 3> nearest{ { Unbounded, Unbounded, Unbounded } };
  for (std::size_t i = first; i < last; ++i)
  {
    const std::array<double, 3>& distances = this->Candidates[i].Distances;
    bound = std::min(bound, *std::max_element(distances.begin(), distances.end()));
    for (std::size_t c = 0; c < 3; ++c)
    {
      nearest[c] = std::min(nearest[c], distances[c]);
    }
  }
  if (bound <= this->Tolerance)
  {
    return bound;
  }
  double longest2;
  const int edge = FindLongestEdge(corners, longest2);
  const double shortest = ShortestSide * this->Tolerance;
  if (*std::max_element(nearest.begin(), nearest.end()) > this->Tolerance ||
    longest2 <= shortest * shortest)
  {
    return Unbounded;
  }
  const std::array<std::size_t, 2> ends{ { static_cast<std::size_t>(edge),
    static_cast<std::size_t>((edge + 1) % 3) } };
  const dvec3 middle = 0.5 * (corners[ends[0]] + corners[ends[1]]);
  bound = 0.0;
  for (std::size_t side = 0; side < 2 && bound < Unbounded; ++side)
  {
    // The middle replaces one end. The distance changes at most by the longest side.
    Corners half = corners;
    half[ends[side]] = middle;
    double halfLongest2;
    FindLongestEdge(half, halfLongest2);
    const double most = this->Tolerance + std::sqrt(halfLongest2);
    for (std::size_t i = first; i < last; ++i)
    {
      Candidate candidate = this->Candidates[i];
      candidate.Distances[ends[side]] = 0.0;
      if (*std::max_element(candidate.Distances.begin(), candidate.Distances.end()) <= most)
      {
        candidate.Distances[ends[side]] =
          std::sqrt(this->Surface.GetDistance2(middle, candidate.Triangle));
        if (candidate.Distances[ends[side]] <= most)
        {
          this->Candidates.push_back(candidate);
        }
      }
    }
    if (this->Candidates.size() == last)
    {
      return Unbounded;
    }
    bound = std::max(bound, this->Bisect(half, last));
    this->Candidates.resize(last);
  }
  return bound;
}
}

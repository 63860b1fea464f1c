// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/LatticeCollapse.h"

#include "Raster/GridKey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace relevo
{
namespace
{
// Triangles have at least this share of the area of a square over their longest edge.
constexpr double SmallestShare = 0.1;

// More passes remove few vertices.
constexpr int NumberOfPasses = 2;

constexpr int VerticesPerAbortCheck = 4096;

using CollapseVertex = LatticeCollapse::Vertex;

// Twice the area of a triangle.
std::int64_t GetDoubleArea(
  const CollapseVertex& a, const CollapseVertex& b, const CollapseVertex& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

std::int64_t GetSquaredLength(const CollapseVertex& a, const CollapseVertex& b)
{
  return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

bool IsWide(const CollapseVertex& a, const CollapseVertex& b, const CollapseVertex& c)
{
  const std::int64_t longest =
    std::max({ GetSquaredLength(a, b), GetSquaredLength(b, c), GetSquaredLength(c, a) });
  return static_cast<double>(GetDoubleArea(a, b, c)) >=
    2.0 * SmallestShare * static_cast<double>(longest);
}
}

LatticeCollapse::LatticeCollapse(
  const std::vector<float>& heights, int columns, int rows, int subdivisions)
  : Heights(heights)
  , Columns(columns)
  , Rows(rows)
  , Subdivisions(subdivisions)
{
}

// The height of the grid at a point within it, in samples.
double LatticeCollapse::Interpolate(double x, double y) const
{
  const int column = std::min(static_cast<int>(x), this->Columns - 2);
  const int row = std::min(static_cast<int>(y), this->Rows - 2);
  const double u = x - column;
  const double v = y - row;
  const float* first = &this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
  const float* second = first + this->Columns;
  // Samples without weight may lack data.
  const auto mix = [](double a, double b, double t) {
    return t <= 0.0 ? a : t >= 1.0 ? b : a + t * (b - a);
  };
  return mix(mix(first[0], first[1], u), mix(second[0], second[1], u), v);
}

// Triangles turn from columns to rows.
void LatticeCollapse::Connect(const std::vector<Triangle>& triangles)
{
  this->Vertices.clear();
  this->Corners.clear();
  std::unordered_map<std::uint64_t, int> ids;
  ids.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
  {
    const bool isPositive = GetDoubleArea(triangle[0], triangle[1], triangle[2]) > 0;
    for (int i : { 0, isPositive ? 1 : 2, isPositive ? 2 : 1 })
    {
      const auto [found, isNew] = ids.emplace(
        MakeGridKey(triangle[i][0], triangle[i][1]), static_cast<int>(this->Vertices.size()));
      if (isNew)
      {
        this->Vertices.push_back(triangle[i]);
      }
      this->Corners.push_back(found->second);
    }
  }
  this->First.assign(this->Vertices.size(), None);
  this->Next.resize(this->Corners.size());
  for (std::size_t corner = 0; corner < this->Corners.size(); ++corner)
  {
    int& first = this->First[this->Corners[corner]];
    this->Next[corner] = std::exchange(first, static_cast<int>(corner));
  }
  const double scale = std::ldexp(1.0, -this->Subdivisions);
  this->VertexHeights.clear();
  for (const Vertex& vertex : this->Vertices)
  {
    const double x = static_cast<double>(vertex[0]) * scale;
    const double y = static_cast<double>(vertex[1]) * scale;
    this->VertexHeights.push_back(
      this->Interpolate(std::min(x, this->Columns - 1.0), std::min(y, this->Rows - 1.0)));
  }
}

// Finds the vertices around one; false at the border of the mesh and near that of the grid.
bool LatticeCollapse::FindRing(int vertex)
{
  // The edges opposite to the vertex.
  constexpr int largest = 24;
  std::array<std::array<int, 2>, largest> edges;
  int number = 0;
  for (int corner = this->First[vertex]; corner != None; corner = this->Next[corner])
  {
    if (this->Corners[corner] != vertex)
    {
      continue; // the triangle has been removed
    }
    if (number == largest)
    {
      return false;
    }
    const int first = corner - corner % 3;
    edges[number] = { { this->Corners[first + (corner + 1) % 3],
      this->Corners[first + (corner + 2) % 3] } };
    ++number;
  }
  this->Ring.clear();
  const std::int64_t last[2] = { static_cast<std::int64_t>(this->Columns - 1) << this->Subdivisions,
    static_cast<std::int64_t>(this->Rows - 1) << this->Subdivisions };
  for (int i = 0; i < number; ++i)
  {
    const int here = i == 0 ? edges[0][0] : this->Ring.back();
    const auto next = std::find_if(edges.begin(), edges.begin() + number,
      [here](const std::array<int, 2>& edge) { return edge[0] == here; });
    if (next == edges.begin() + number || this->Vertices[here][0] > last[0] ||
      this->Vertices[here][1] > last[1])
    {
      return false;
    }
    this->Ring.push_back((*next)[1]);
  }
  return number > 2 && this->Ring.back() == edges[0][0];
}

// The distance at a vertex inside of the ring if the ring is a fan around one of its vertices;
// negative if triangles of the fan are too narrow.
double LatticeCollapse::MeasureAt(const Vertex& point, int first) const
{
  const int size = static_cast<int>(this->Ring.size());
  const auto getId = [&](int i) { return this->Ring[(first + i) % size]; };
  double height = 0.0;
  bool isFound = false;
  for (int i = 1; i + 1 < size; ++i)
  {
    const int ids[3] = { getId(0), getId(i), getId(i + 1) };
    const Vertex& a = this->Vertices[ids[0]];
    const Vertex& b = this->Vertices[ids[1]];
    const Vertex& c = this->Vertices[ids[2]];
    if (!IsWide(a, b, c))
    {
      return -1.0;
    }
    const std::int64_t areas[3] = { GetDoubleArea(b, c, point), GetDoubleArea(c, a, point),
      GetDoubleArea(a, b, point) };
    if (!isFound && areas[0] >= 0 && areas[1] >= 0 && areas[2] >= 0)
    {
      isFound = true;
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        sum += static_cast<double>(areas[k]) * this->VertexHeights[ids[k]];
      }
      height = sum / static_cast<double>(GetDoubleArea(a, b, c));
    }
  }
  const double scale = std::ldexp(1.0, -this->Subdivisions);
  return isFound ? std::abs(height -
                     this->Interpolate(static_cast<double>(point[0]) * scale,
                       static_cast<double>(point[1]) * scale))
                 : -1.0;
}

bool LatticeCollapse::IsFanWithin(int first) const
{
  const int size = static_cast<int>(this->Ring.size());
  const auto getId = [&](int i) { return this->Ring[(first + i) % size]; };
  for (int i = 1; i + 1 < size; ++i)
  {
    // The outer edges are those of triangles within the tolerance.
    const int ids[3] = { getId(0), getId(i), getId(i + 1) };
    if ((i > 1 && !this->IsEdgeWithin(ids[0], ids[1])) || !this->IsTriangleWithin(ids))
    {
      return false;
    }
  }
  return true;
}

// The distances at the samples in a triangle.
bool LatticeCollapse::IsTriangleWithin(const int ids[3]) const
{
  const Vertex& a = this->Vertices[ids[0]];
  const Vertex& b = this->Vertices[ids[1]];
  const Vertex& c = this->Vertices[ids[2]];
  const int shift = this->Subdivisions;
  const auto getFirst = [shift](std::int64_t x)
  { return (x + (std::int64_t(1) << shift) - 1) >> shift; };
  const double share = 1.0 / static_cast<double>(GetDoubleArea(a, b, c));
  for (std::int64_t row = getFirst(std::min({ a[1], b[1], c[1] }));
       row <= std::max({ a[1], b[1], c[1] }) >> shift; ++row)
  {
    for (std::int64_t column = getFirst(std::min({ a[0], b[0], c[0] }));
         column <= std::max({ a[0], b[0], c[0] }) >> shift; ++column)
    {
      const Vertex point = { { column << shift, row << shift } };
      const std::int64_t areas[3] = { GetDoubleArea(b, c, point), GetDoubleArea(c, a, point),
        GetDoubleArea(a, b, point) };
      if (areas[0] < 0 || areas[1] < 0 || areas[2] < 0)
      {
        continue;
      }
      double height = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        height += static_cast<double>(areas[k]) * this->VertexHeights[ids[k]];
      }
      const float sample = this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
      if (!(std::abs(height * share - sample) <= this->Tolerance))
      {
        return false;
      }
    }
  }
  return true;
}

// The distance is quadratic between the points where an edge crosses rows and columns of the grid.
bool LatticeCollapse::IsEdgeWithin(int first, int second) const
{
  const double scale = std::ldexp(1.0, -this->Subdivisions);
  double begin[2];
  double step[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    begin[axis] = static_cast<double>(this->Vertices[first][axis]) * scale;
    step[axis] = static_cast<double>(this->Vertices[second][axis]) * scale - begin[axis];
  }
  const double heights[2] = { this->VertexHeights[first], this->VertexHeights[second] };
  const auto measure = [&](double t)
  {
    return heights[0] + t * (heights[1] - heights[0]) -
      this->Interpolate(begin[0] + t * step[0], begin[1] + t * step[1]);
  };
  const auto isWithin = [this](double distance) { return std::abs(distance) <= this->Tolerance; };
  // The next line that the edge crosses, along each axis.
  double next[2];
  double period[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double sign = step[axis] > 0.0 ? 1.0 : -1.0;
    const double line = sign * (std::floor(sign * begin[axis]) + 1.0);
    const bool isMoving = std::abs(step[axis]) > 0.0;
    next[axis] = isMoving ? (line - begin[axis]) / step[axis] : 2.0;
    period[axis] = isMoving ? 1.0 / std::abs(step[axis]) : 2.0;
  }
  double t = 0.0;
  double distance = measure(0.0);
  while (t < 1.0)
  {
    const double end = std::min({ next[0], next[1], 1.0 });
    for (int axis = 0; axis < 2; ++axis)
    {
      next[axis] += next[axis] <= end ? period[axis] : 0.0;
    }
    const double after = measure(end);
    const double bulge = 4.0 * measure(0.5 * (t + end)) - 2.0 * (distance + after);
    // distance + s * (after - distance) + bulge * s * (1 - s)
    const double change = after - distance;
    if (std::abs(bulge) > std::abs(change))
    {
      const double s = 0.5 + 0.5 * change / bulge;
      if (!isWithin(distance + s * change + bulge * s * (1.0 - s)))
      {
        return false;
      }
    }
    if (!isWithin(after))
    {
      return false;
    }
    t = end;
    distance = after;
  }
  return true;
}

bool LatticeCollapse::Remove(int vertex)
{
  if (!this->FindRing(vertex))
  {
    return false;
  }
  const int size = static_cast<int>(this->Ring.size());
  this->Candidates.clear();
  for (int i = 0; i < size; ++i)
  {
    const double distance = this->MeasureAt(this->Vertices[vertex], i);
    if (distance >= 0.0 && distance <= this->Tolerance)
    {
      this->Candidates.push_back({ i, distance });
    }
  }
  std::sort(this->Candidates.begin(), this->Candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Distance < b.Distance; });
  for (const Candidate& candidate : this->Candidates)
  {
    if (!this->IsFanWithin(candidate.Index))
    {
      continue;
    }
    const int target = this->Ring[candidate.Index];
    int corner = this->First[vertex];
    while (corner != None)
    {
      const int next = this->Next[corner];
      if (this->Corners[corner] == vertex)
      {
        const int first = corner - corner % 3;
        const bool isRemoved = std::find(&this->Corners[first], &this->Corners[first] + 3,
                                 target) != &this->Corners[first] + 3;
        if (isRemoved)
        {
          std::fill_n(&this->Corners[first], 3, None);
        }
        else
        {
          this->Corners[corner] = target;
          this->Next[corner] = std::exchange(this->First[target], corner);
        }
      }
      corner = next;
    }
    this->First[vertex] = None;
    return true;
  }
  return false;
}

bool LatticeCollapse::Collapse(
  std::vector<Triangle>& triangles, double tolerance, const std::function<bool()>& isAborted)
{
  this->Tolerance = tolerance;
  this->Connect(triangles);
  for (int pass = 0; pass < NumberOfPasses; ++pass)
  {
    for (int vertex = 0; vertex < static_cast<int>(this->Vertices.size()); ++vertex)
    {
      if (vertex % VerticesPerAbortCheck == 0 && isAborted())
      {
        return false;
      }
      this->Remove(vertex);
    }
  }
  triangles.clear();
  for (std::size_t corner = 0; corner < this->Corners.size(); corner += 3)
  {
    if (this->Corners[corner] != None)
    {
      Triangle triangle;
      for (int i = 0; i < 3; ++i)
      {
        triangle[i] = this->Vertices[this->Corners[corner + i]];
      }
      triangles.push_back(triangle);
    }
  }
  return true;
}
}

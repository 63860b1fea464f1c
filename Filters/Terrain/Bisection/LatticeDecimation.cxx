// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/LatticeDecimation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace relevo
{
namespace
{
using DecimationVertex = LatticeDecimation::Vertex;
using DecimationTriangle = LatticeDecimation::Triangle;

// Heights that are finer than the rounding of floats cannot be reached.
constexpr int MaximumSubdivisions = 8;

std::uint64_t GetVertexKey(const DecimationVertex& vertex)
{
  return static_cast<std::uint64_t>(vertex[1]) << 32 | static_cast<std::uint64_t>(vertex[0]);
}

// The longest side is between the first two vertices of a triangle.
DecimationVertex GetMidpoint(const DecimationTriangle& triangle)
{
  return { { (triangle[0][0] + triangle[1][0]) / 2, (triangle[0][1] + triangle[1][1]) / 2 } };
}

// The length of a leg along the axes.
std::int64_t GetLeg(const DecimationTriangle& triangle)
{
  return std::abs(triangle[0][0] - triangle[2][0]) + std::abs(triangle[0][1] - triangle[2][1]);
}

std::array<DecimationTriangle, 2> Bisect(const DecimationTriangle& triangle)
{
  const DecimationVertex middle = GetMidpoint(triangle);
  return { { { { triangle[2], triangle[0], middle } }, { { triangle[1], triangle[2], middle } } } };
}
}

LatticeDecimation::LatticeDecimation(std::vector<float> heights, int columns, int rows)
  : Heights(std::move(heights))
  , Columns(columns)
  , Rows(rows)
{
}

// Twice the height of the middle of one diagonal of a cell above that of the other.
double LatticeDecimation::GetTwist(int column, int row) const
{
  const float* first = &this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
  const float* second = first + this->Columns;
  return static_cast<double>(first[0]) + second[1] - first[1] - second[0];
}

double LatticeDecimation::GetLargestTwist() const
{
  double largest = 0.0;
  for (int row = 0; row + 1 < this->Rows; ++row)
  {
    for (int column = 0; column + 1 < this->Columns; ++column)
    {
      const double twist = std::abs(this->GetTwist(column, row));
      largest = twist > largest ? twist : largest; // false for NaN
    }
  }
  return largest;
}

// Two triangles differ from a bilinear cell by a quarter of its twist, four parts of it by a
// quarter of that, and so on.
void LatticeDecimation::ChooseSubdivisions()
{
  this->Subdivisions = 0;
  for (double error = this->GetLargestTwist() / 4.0;
       error > this->Tolerance && this->Subdivisions < MaximumSubdivisions; error /= 4.0)
  {
    ++this->Subdivisions;
  }
}

double LatticeDecimation::GetHeight(const Vertex& vertex) const
{
  const double scale = std::ldexp(1.0, -this->Subdivisions);
  const double x = std::min(static_cast<double>(vertex[0]) * scale, this->Columns - 1.0);
  const double y = std::min(static_cast<double>(vertex[1]) * scale, this->Rows - 1.0);
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double u = x - column;
  const double v = y - row;
  const float* first = &this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
  const float* second = v > 0.0 ? first + this->Columns : first;
  const int next = u > 0.0 ? 1 : 0;
  const auto mix = [](double a, double b, double t) { return t > 0.0 ? a + t * (b - a) : a; };
  return mix(mix(first[0], first[next], u), mix(second[0], second[next], u), v);
}

// The largest distance of a triangle from the surface.
double LatticeDecimation::Measure(const Triangle& triangle, Content& content) const
{
  const int shift = this->Subdivisions;
  const std::int64_t unit = std::int64_t(1) << shift;
  Vertex low = triangle[0];
  Vertex high = triangle[0];
  for (const Vertex& vertex : triangle)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], vertex[axis]);
      high[axis] = std::max(high[axis], vertex[axis]);
    }
  }
  // Cells from first to last, of those in the grid.
  const std::int64_t first[2] = { low[0] >> shift, low[1] >> shift };
  const std::int64_t last[2] = { std::min<std::int64_t>(
                                   (high[0] + unit - 1) >> shift, this->Columns - 1),
    std::min<std::int64_t>((high[1] + unit - 1) >> shift, this->Rows - 1) };
  content = Content::Nothing;
  if (first[0] >= this->Columns - 1 || first[1] >= this->Rows - 1)
  {
    return 0.0;
  }
  const std::int64_t area = (triangle[1][0] - triangle[0][0]) * (triangle[2][1] - triangle[0][1]) -
    (triangle[1][1] - triangle[0][1]) * (triangle[2][0] - triangle[0][0]);
  const double heights[3] = { this->GetHeight(triangle[0]), this->GetHeight(triangle[1]),
    this->GetHeight(triangle[2]) };
  // Twice the areas of the triangles of a point and two vertices, positive inside.
  const auto weigh = [&](std::int64_t x, std::int64_t y, std::int64_t weights[3])
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vertex& a = triangle[(i + 1) % 3];
      const Vertex& b = triangle[(i + 2) % 3];
      const std::int64_t cross = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      weights[i] = area > 0 ? cross : -cross;
    }
  };
  const auto isInside = [](const std::int64_t weights[3])
  { return weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0; };
  const double scale = 1.0 / static_cast<double>(std::abs(area));
  bool hasData = false;
  bool hasHoles = false;
  double error = 0.0;
  // Subdivided cells: the surface differs from a triangle by a part of the twist.
  if (high[0] - low[0] <= unit && high[1] - low[1] <= unit)
  {
    const int column = static_cast<int>(first[0]);
    const int row = static_cast<int>(first[1]);
    const double twist = std::abs(this->GetTwist(column, row));
    const bool hasLegsAlongAxes =
      triangle[0][0] != triangle[1][0] && triangle[0][1] != triangle[1][1];
    const double length =
      static_cast<double>(std::max(high[0] - low[0], high[1] - low[1])) / static_cast<double>(unit);
    content = std::isnan(twist) ? Content::Nothing : Content::Surface;
    return std::isnan(twist) ? 0.0 : twist * length * length / (hasLegsAlongAxes ? 4.0 : 16.0);
  }
  for (std::int64_t row = first[1]; row <= last[1]; ++row)
  {
    for (std::int64_t column = first[0]; column <= last[0]; ++column)
    {
      std::int64_t weights[3];
      weigh(column << shift, row << shift, weights);
      if (!isInside(weights))
      {
        continue;
      }
      const float height = this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
      if (std::isnan(height))
      {
        hasHoles = true;
        continue;
      }
      hasData = true;
      double drawn = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        drawn += static_cast<double>(weights[i]) * scale * heights[i];
      }
      double distance = std::abs(drawn - height);
      // A diagonal side cuts two of the cells around the sample. In their halves the distance is
      // linear between the corners, but for a part of the twist.
      for (int i = 0; i < 3; ++i)
      {
        const Vertex& a = triangle[(i + 1) % 3];
        const Vertex& b = triangle[(i + 2) % 3];
        const bool isMain = (b[0] > a[0]) == (b[1] > a[1]);
        if (weights[i] != 0 || a[0] == b[0] || a[1] == b[1])
        {
          continue;
        }
        for (int cell = 0; cell < 2; ++cell)
        {
          const std::int64_t c = column - cell;
          const std::int64_t r = row - (isMain ? cell : 1 - cell);
          if (c >= low[0] >> shift && r >= low[1] >> shift && c < last[0] && r < last[1])
          {
            const double twist = std::abs(this->GetTwist(static_cast<int>(c), static_cast<int>(r)));
            hasHoles = hasHoles || std::isnan(twist);
            distance = std::max(distance, std::abs(drawn - height) + twist / 4.0);
          }
        }
      }
      error = distance > error ? distance : error;
    }
  }
  content = hasHoles ? (hasData ? Content::Mixed : Content::Nothing) : Content::Surface;
  return error;
}

// Bisects a triangle if its surface or that of its parts needs it.
void LatticeDecimation::Visit(const Triangle& triangle)
{
  const Vertex& apex = triangle[2];
  if (GetLeg(triangle) <= 1 || this->WasAborted)
  {
    return;
  }
  const Vertex middle = GetMidpoint(triangle);
  if (!this->IsMarked(middle))
  {
    // The direction from the midpoint to the apex tells the two triangles of a side apart.
    const auto sign = [](std::int64_t x) { return x > 0 ? 2 : x < 0 ? 1 : 0; };
    const std::uint64_t key = GetVertexKey(middle) * 9 +
      static_cast<std::uint64_t>(3 * sign(apex[0] - middle[0]) + sign(apex[1] - middle[1]));
    if (this->Accepted.count(key) != 0)
    {
      return;
    }
    Content content = Content::Surface;
    const double error = this->Measure(triangle, content);
    if (content == Content::Nothing || (content == Content::Surface && error <= this->Tolerance))
    {
      this->Accepted.insert(key);
      return;
    }
    this->WasAborted = this->WasAborted || (*this->IsAborted)();
    this->Mark(middle);
    this->HasChanged = true;
  }
  for (const Triangle& half : Bisect(triangle))
  {
    this->Visit(half);
  }
}

bool LatticeDecimation::IsMarked(const Vertex& vertex) const
{
  return this->Marked.count(GetVertexKey(vertex)) != 0;
}

// Bisects at a vertex, after the bisections that make the two triangles around it.
void LatticeDecimation::Mark(const Vertex& vertex)
{
  const auto isBeyond = [this](const Vertex& v)
  { return v[0] < 0 || v[1] < 0 || v[0] > this->Size || v[1] > this->Size; };
  const bool isCorner =
    vertex[0] % this->Size == 0 && vertex[1] % this->Size == 0; // of the largest square
  if (isBeyond(vertex) || isCorner || !this->Marked.insert(GetVertexKey(vertex)).second)
  {
    return;
  }
  std::int64_t step = 1;
  while (((vertex[0] | vertex[1]) & step) == 0)
  {
    step *= 2;
  }
  const bool isColumnOdd = (vertex[0] & step) != 0;
  const bool isRowOdd = (vertex[1] & step) != 0;
  std::int64_t x = isRowOdd ? step : 0;
  std::int64_t y = isColumnOdd ? step : 0;
  if (isColumnOdd && isRowOdd)
  {
    // The center of a square: the apexes are not on the diagonal that halves it.
    const bool isMain = (vertex[0] / (2 * step) + vertex[1] / (2 * step)) % 2 == 0;
    y = isMain ? -step : step;
  }
  this->Mark({ { vertex[0] + x, vertex[1] + y } });
  this->Mark({ { vertex[0] - x, vertex[1] - y } });
}

void LatticeDecimation::Collect(const Triangle& triangle)
{
  if (this->IsMarked(GetMidpoint(triangle)) && GetLeg(triangle) > 1)
  {
    for (const Triangle& half : Bisect(triangle))
    {
      this->Collect(half);
    }
    return;
  }
  Content content = Content::Surface;
  this->Measure(triangle, content);
  if (content == Content::Surface)
  {
    this->Triangles.push_back(triangle);
  }
}

bool LatticeDecimation::Refine(double tolerance, const std::function<bool()>& isAborted)
{
  this->Tolerance = tolerance;
  this->IsAborted = &isAborted;
  this->WasAborted = false;
  this->Marked.clear();
  this->Accepted.clear();
  this->Triangles.clear();
  this->ChooseSubdivisions();
  this->Size = std::int64_t(1) << this->Subdivisions;
  while (this->Size >> this->Subdivisions < std::max(this->Columns, this->Rows) - 1)
  {
    this->Size *= 2;
  }
  const std::int64_t n = this->Size;
  const Triangle halves[2] = { { { { { 0, 0 } }, { { n, n } }, { { n, 0 } } } },
    { { { { n, n } }, { { 0, 0 } }, { { 0, n } } } } };
  do
  {
    this->HasChanged = false;
    for (const Triangle& half : halves)
    {
      this->Visit(half);
    }
  } while (this->HasChanged && !this->WasAborted);
  for (const Triangle& half : halves)
  {
    this->Collect(half);
  }
  return !this->WasAborted;
}
}

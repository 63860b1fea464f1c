// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/LatticeDecimation.h"

#include "Bisection/LatticeCollapse.h"
#include "Raster/GridKey.h"

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
  return MakeGridKey(vertex[0], vertex[1]);
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

double GetLargerOrNaN(double a, double b)
{
  return std::isnan(a) || a >= b ? a : b;
}

// The samples of a grid between which a triangle lies, along an axis.
struct Range
{
  std::int64_t First;
  std::int64_t Last;

  Range(const DecimationTriangle& triangle, int axis, int shift, int size)
  {
    const auto [low, high] =
      std::minmax({ triangle[0][axis], triangle[1][axis], triangle[2][axis] });
    this->First = low >> shift;
    this->Last = std::min<std::int64_t>((high + (std::int64_t(1) << shift) - 1) >> shift, size - 1);
  }
};

// Interpolates in a triangle.
class Barycenter
{
public:
  explicit Barycenter(const DecimationTriangle& triangle)
    : Triangle(triangle)
    , Area(FindArea(triangle[0], triangle[1], triangle[2]))
  {
  }

  // Twice the areas of the triangles of the point and two vertices; false outside.
  bool FindAreas(std::int64_t x, std::int64_t y, std::int64_t areas[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::int64_t area =
        FindArea(this->Triangle[(i + 1) % 3], this->Triangle[(i + 2) % 3], { { x, y } });
      areas[i] = this->Area > 0 ? area : -area;
    }
    return areas[0] >= 0 && areas[1] >= 0 && areas[2] >= 0;
  }

  double Interpolate(const std::int64_t areas[3], const double heights[3]) const
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      sum += static_cast<double>(areas[i]) * heights[i];
    }
    return sum / static_cast<double>(std::abs(this->Area));
  }

private:
  static std::int64_t FindArea(
    const DecimationVertex& a, const DecimationVertex& b, const DecimationVertex& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  const DecimationTriangle& Triangle;
  std::int64_t Area; // twice
};

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

double LatticeDecimation::GetShapeError(const Triangle& triangle) const
{
  if (!this->FindShapeError)
  {
    return 0.0;
  }
  const double scale = std::ldexp(1.0, -this->Subdivisions);
  Bounds bounds;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto [low, high] =
      std::minmax({ triangle[0][axis], triangle[1][axis], triangle[2][axis] });
    bounds[axis] = { { static_cast<double>(low) * scale, static_cast<double>(high) * scale } };
  }
  return this->FindShapeError(bounds);
}

// Two triangles differ from a bilinear cell by a quarter of its twist, four parts of it by a
// quarter of that, and so on.
// Returns false if they would be too many.
bool LatticeDecimation::ChooseSubdivisions()
{
  this->Subdivisions = 0;
  double error = this->GetLargestTwist() / 4.0 + this->ShapeErrorOfCell;
  for (; error > this->Tolerance && this->Subdivisions < MaximumSubdivisions; error /= 4.0)
  {
    ++this->Subdivisions;
  }
  return error <= this->Tolerance;
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

// The distance of a triangle within a cell from the surface: a part of the twist.
double LatticeDecimation::MeasureInCell(const Triangle& triangle, Content& content) const
{
  const int shift = this->Subdivisions;
  const std::int64_t column = std::min({ triangle[0][0], triangle[1][0], triangle[2][0] }) >> shift;
  const std::int64_t row = std::min({ triangle[0][1], triangle[1][1], triangle[2][1] }) >> shift;
  const double twist = std::abs(this->GetTwist(static_cast<int>(column), static_cast<int>(row)));
  content = std::isnan(twist) ? Content::Nothing : Content::Surface;
  const std::int64_t x = std::abs(triangle[0][0] - triangle[1][0]);
  const std::int64_t y = std::abs(triangle[0][1] - triangle[1][1]);
  const double length = std::ldexp(static_cast<double>(std::max(x, y)), -shift);
  const bool hasLegsAlongAxes = x != 0 && y != 0;
  return std::isnan(twist) ? 0.0 : twist * length * length / (hasLegsAlongAxes ? 4.0 : 16.0);
}

// The largest twist of the cells that a diagonal side through a sample cuts, within a triangle.
double LatticeDecimation::GetTwistOfSide(
  const Triangle& triangle, int side, std::int64_t column, std::int64_t row) const
{
  const Vertex& a = triangle[(side + 1) % 3];
  const Vertex& b = triangle[(side + 2) % 3];
  if (a[0] == b[0] || a[1] == b[1])
  {
    return 0.0;
  }
  const bool isMain = (b[0] > a[0]) == (b[1] > a[1]);
  const auto isBetween = [this, &a, &b](std::int64_t cell, int axis)
  {
    const std::int64_t low = std::min(a[axis], b[axis]) >> this->Subdivisions;
    const std::int64_t high = std::max(a[axis], b[axis]) >> this->Subdivisions;
    return cell >= low && cell < high && cell + 1 < (axis == 0 ? this->Columns : this->Rows);
  };
  double largest = 0.0;
  for (int cell = 0; cell < 2; ++cell)
  {
    const std::int64_t c = column - cell;
    const std::int64_t r = row - (isMain ? cell : 1 - cell);
    if (isBetween(c, 0) && isBetween(r, 1))
    {
      const double twist = std::abs(this->GetTwist(static_cast<int>(c), static_cast<int>(r)));
      largest = GetLargerOrNaN(largest, twist);
    }
  }
  return largest;
}

// The largest distance of a triangle from the bilinear surface.
double LatticeDecimation::MeasureHeights(const Triangle& triangle, Content& content) const
{
  const int shift = this->Subdivisions;
  const Range columns(triangle, 0, shift, this->Columns);
  const Range rows(triangle, 1, shift, this->Rows);
  content = Content::Nothing;
  if (columns.First + 1 >= this->Columns || rows.First + 1 >= this->Rows)
  {
    return 0.0;
  }
  if (GetLeg(triangle) <= std::int64_t(1) << shift)
  {
    return this->MeasureInCell(triangle, content);
  }
  const double heights[3] = { this->GetHeight(triangle[0]), this->GetHeight(triangle[1]),
    this->GetHeight(triangle[2]) };
  const Barycenter barycenter(triangle);
  bool hasData = false;
  bool hasHoles = false;
  double error = 0.0;
  for (std::int64_t row = rows.First; row <= rows.Last; ++row)
  {
    for (std::int64_t column = columns.First; column <= columns.Last; ++column)
    {
      std::int64_t areas[3];
      if (!barycenter.FindAreas(column << shift, row << shift, areas))
      {
        continue;
      }
      const float height = this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
      hasHoles = hasHoles || std::isnan(height);
      hasData = hasData || !std::isnan(height);
      // A diagonal side cuts cells in halves. In a half, the distance is linear between the corners
      // plus a term that is largest on the side, where it is at most a quarter of the twist.
      double twist = 0.0;
      for (int side = 0; side < 3; ++side)
      {
        const double candidate =
          areas[side] == 0 ? this->GetTwistOfSide(triangle, side, column, row) : 0.0;
        twist = GetLargerOrNaN(twist, candidate);
      }
      hasHoles = hasHoles || std::isnan(twist);
      const double distance =
        std::abs(barycenter.Interpolate(areas, heights) - height) + twist / 4.0;
      error = distance > error ? distance : error; // false for NaN
    }
  }
  content = hasHoles ? (hasData ? Content::Mixed : Content::Nothing) : Content::Surface;
  return error;
}

double LatticeDecimation::Measure(const Triangle& triangle, Content& content) const
{
  const double distance = this->MeasureHeights(triangle, content);
  return content == Content::Nothing ? 0.0 : distance + this->GetShapeError(triangle);
}

void LatticeDecimation::CountProgress(const Triangle& triangle)
{
  const double share = static_cast<double>(GetLeg(triangle)) / static_cast<double>(this->Size);
  this->Progress = std::min(1.0, this->Progress + share * share / 2.0);
}

// Bisects a triangle if its surface or that of its parts needs it.
void LatticeDecimation::Visit(const Triangle& triangle)
{
  const Vertex& apex = triangle[2];
  if (GetLeg(triangle) <= 1 || this->State != Result::Done)
  {
    this->CountProgress(triangle);
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
      this->CountProgress(triangle);
      return;
    }
    if ((*this->IsAborted)())
    {
      this->State = Result::Aborted;
    }
    // Each midpoint bisects two triangles.
    if (this->Marked.size() > MaximumTriangles / 2)
    {
      this->State = Result::TooManyTriangles;
    }
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
    // The centre of a square: the apexes are not on the diagonal that halves it.
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
  const double error = this->Measure(triangle, content);
  if (content == Content::Surface)
  {
    this->Error = std::max(this->Error, error);
    this->Triangles.push_back(triangle);
  }
}

LatticeDecimation::Result LatticeDecimation::Refine(
  double tolerance, const std::function<bool()>& isAborted)
{
  this->Tolerance = tolerance;
  this->IsAborted = &isAborted;
  this->State = Result::Done;
  this->Marked.clear();
  this->Accepted.clear();
  this->Triangles.clear();
  this->Error = 0.0;
  this->Progress = 0.0;
  if (!this->ChooseSubdivisions())
  {
    return Result::TooManyTriangles;
  }
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
  } while (this->HasChanged && this->State == Result::Done);
  for (const Triangle& half : halves)
  {
    this->Collect(half);
  }
  if (this->State != Result::Done || this->FindShapeError)
  {
    return this->State;
  }
  const std::size_t count = this->Triangles.size();
  LatticeCollapse collapse(this->Heights, this->Columns, this->Rows, this->Subdivisions);
  if (!collapse.Collapse(this->Triangles, tolerance, isAborted))
  {
    this->State = Result::Aborted;
  }
  this->Error = this->Triangles.size() < count ? tolerance : this->Error;
  return this->State;
}
}

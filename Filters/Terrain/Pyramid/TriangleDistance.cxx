// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/TriangleDistance.h"

#include "Lattice/BlockErrors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace relevo
{
namespace
{
constexpr int ShiftOfBlocks = 3;
static_assert(BlockErrors::CellsPerBlock == 1 << ShiftOfBlocks, "shift and size must agree");

// Comparisons with NaN are false.
void RaiseTo(double& largest, double value)
{
  largest = value > largest ? value : largest;
}

// The distances of base + i * slope for i from `begin` to before `end`.
void MeasureRamp(
  double base, double slope, const double* reference, int begin, int end, double* largest)
{
  for (int i = begin; i < end; ++i)
  {
    RaiseTo(largest[i], std::abs(base + i * slope - reference[i]));
  }
}
}

void TriangleDistance::SetTriangulated(const std::array<int, 2>& firstCell)
{
  this->IsTriangulated = true;
  this->Diagonals.FirstCell = firstCell;
}

ValueGrid<double> TriangleDistance::Measure(const TriangulatedGrid& grid, int blockShift) const
{
  const int cellsPerBlock = 1 << blockShift;
  const int columns = (this->Reference.Width - 2 + cellsPerBlock) >> blockShift;
  const int rows = (this->Reference.Height - 2 + cellsPerBlock) >> blockShift;
  ValueGrid<double> result(columns, rows, -1.0);
  std::vector<double> largest(this->Reference.Width, -1.0); // in the columns of a row of blocks
  std::vector<double> line(this->Reference.Width);
  const auto finish = [&](int blockRow)
  {
    for (int block = 0; block < columns; ++block)
    {
      double& blockResult = result.At(block, blockRow);
      const int last = std::min((block + 1) << blockShift, this->Reference.Width - 1);
      for (int x = block << blockShift; x <= last; ++x)
      {
        RaiseTo(blockResult, largest[x]);
      }
    }
  };
  for (int y = 0; y < this->Reference.Height; ++y)
  {
    const int blockRow = y >> blockShift;
    if (y > 0 && y % cellsPerBlock == 0)
    {
      // The row belongs to two rows of blocks.
      std::fill(line.begin(), line.end(), -1.0);
      this->MeasureRow(grid, y, line.data());
      for (int x = 0; x < this->Reference.Width; ++x)
      {
        RaiseTo(largest[x], line[x]);
      }
      finish(blockRow - 1);
      largest = line;
    }
    else
    {
      this->MeasureRow(grid, y, largest.data());
    }
    if (y < this->Reference.Height - 1)
    {
      this->MeasureDiagonals(grid, y, blockShift, &result.At(0, blockRow));
    }
    if (y == this->Reference.Height - 1 && y % cellsPerBlock != 0)
    {
      finish(blockRow);
    }
  }
  return result;
}

// Adds the distances at a row, which is 0 to the size of a block, in a row of blocks.
void TriangleDistance::MeasureRowOfBlocks(
  const std::vector<double>& line, int row, int blockShift, ValueGrid<Sides>& result) const
{
  const int size = 1 << blockShift;
  const int blockRow = std::min(row >> blockShift, result.Height - 1);
  for (int blocks = row % size == 0 && row > 0 && blockRow == row >> blockShift ? 2 : 1; blocks > 0;
       --blocks)
  {
    const int v = row - ((blockRow - blocks + 1) << blockShift);
    const int border = std::min(v, size - v);
    for (int block = 0; block < result.Width; ++block)
    {
      Sides& sides = result.At(block, blockRow - blocks + 1);
      const double* first = line.data() + (block << blockShift);
      const int last = std::min(size, this->Reference.Width - 1 - (block << blockShift));
      const auto raise = [&](int side, int begin, int end)
      {
        double largest = sides[side];
        for (int u = begin; u <= std::min(end, last); ++u)
        {
          RaiseTo(largest, first[u]);
        }
        sides[side] = largest;
      };
      raise(3, 0, border);
      raise(1, size - border, size);
      if (2 * v <= size)
      {
        raise(0, border, size - border);
      }
      if (2 * v >= size)
      {
        raise(2, border, size - border);
      }
    }
  }
}

ValueGrid<TriangleDistance::Sides> TriangleDistance::MeasureSides(
  const TriangulatedGrid& grid, int blockShift) const
{
  const int size = 1 << blockShift;
  const int columns = (this->Reference.Width - 2 + size) >> blockShift;
  const int rows = (this->Reference.Height - 2 + size) >> blockShift;
  ValueGrid<Sides> result(columns, rows, { { -1.0, -1.0, -1.0, -1.0 } });
  std::vector<double> line(this->Reference.Width);
  for (int y = 0; y < this->Reference.Height; ++y)
  {
    std::fill(line.begin(), line.end(), -1.0);
    this->MeasureRow(grid, y, line.data());
    this->MeasureRowOfBlocks(line, y, blockShift, result);
    if (y == this->Reference.Height - 1)
    {
      break;
    }
    std::fill(line.begin(), line.end(), -1.0);
    this->MeasureDiagonals(grid, y, 0, line.data());
    for (int x = 0; x + 1 < this->Reference.Width; ++x)
    {
      if (line[x] >= 0.0)
      {
        Sides& sides = result.At(x >> blockShift, y >> blockShift);
        ForSides(
          x & (size - 1), y & (size - 1), size, [&](int side) { RaiseTo(sides[side], line[x]); });
      }
    }
  }
  return result;
}

// The distances at the samples of a row. Edges of triangles count where both ends have data.
void TriangleDistance::MeasureRow(const TriangulatedGrid& grid, int row, double* largest) const
{
  const double* reference = this->Reference.GetRow(row);
  const int size = 1 << grid.Shift;
  const int gridRow = row >> grid.Shift;
  const int v = row - (gridRow << grid.Shift);
  const double* top = &grid.Heights[static_cast<std::size_t>(gridRow) * grid.Width];
  if (size == 1)
  {
    for (int x = 0; x < this->Reference.Width; ++x)
    {
      RaiseTo(largest[x], std::abs(top[x] - reference[x]));
    }
    return;
  }
  const double share = 1.0 / size;
  const double* bottom = v > 0 ? top + grid.Width : top;
  const double weight = v * share;
  const auto mix = [weight](double a, double b) { return a + weight * (b - a); };
  const int cells = (this->Reference.Width - 2 + size) >> grid.Shift; // the grid can have more
  double left = v > 0 ? mix(top[0], bottom[0]) : top[0];
  for (int cell = 0; cell < cells; ++cell)
  {
    const int x = cell << grid.Shift;
    const int end = std::min(size, this->Reference.Width - x);
    const double right = v > 0 ? mix(top[cell + 1], bottom[cell + 1]) : top[cell + 1];
    RaiseTo(largest[x], std::abs(left - reference[x]));
    if (v == 0)
    {
      MeasureRamp(left, (right - left) * share, reference + x, 1, end, largest + x);
    }
    else
    {
      const bool isMain = grid.IsMain(cell, gridRow);
      const int knot = isMain ? v : size - v;
      const double atKnot =
        isMain ? mix(top[cell], bottom[cell + 1]) : mix(top[cell + 1], bottom[cell]);
      const double topSlope = (top[cell + 1] - top[cell]) * share;
      const double bottomSlope = (bottom[cell + 1] - bottom[cell]) * share;
      const double first = isMain ? bottomSlope : topSlope;
      const double second = isMain ? topSlope : bottomSlope;
      MeasureRamp(left, first, reference + x, 1, std::min(knot, end), largest + x);
      if (knot < end)
      {
        RaiseTo(largest[x + knot], std::abs(atKnot - reference[x + knot]));
      }
      MeasureRamp(right - size * second, second, reference + x, knot + 1, end, largest + x);
    }
    left = right;
  }
  const int last = cells << grid.Shift;
  if (last < this->Reference.Width)
  {
    RaiseTo(largest[last], std::abs(left - reference[last]));
  }
}

// The largest distance inside of a cell with a diagonal; its ends have these distances, with signs.
double TriangleDistance::GetDiagonalDistance(
  bool isMain, int column, int row, double first, double second) const
{
  const double* top = this->Reference.GetRow(row) + column;
  const double* bottom = top + this->Reference.Width;
  double twist = top[0] + bottom[1] - top[1] - bottom[0];
  twist = isMain ? twist : -twist;
  const double middle = 0.5 * (first + second);
  if (this->IsTriangulated)
  {
    return this->Diagonals.IsMain(column, row) == isMain ? -1.0 : std::abs(middle + 0.5 * twist);
  }
  // The distance along the diagonal is linear plus a parabola with the height |twist| / 4.
  const double half = 0.5 * std::abs(second - first);
  const double parabola = 0.25 * twist;
  return std::max(
    middle + half + std::max(parabola, 0.0), half - middle + std::max(-parabola, 0.0));
}

// The cells between a row and the next that a diagonal crosses.
void TriangleDistance::MeasureDiagonals(
  const TriangulatedGrid& grid, int row, int blockShift, double* largest) const
{
  const double* reference = this->Reference.GetRow(row);
  const double* next = reference + this->Reference.Width;
  const int size = 1 << grid.Shift;
  const int gridRow = row >> grid.Shift;
  const int v = row - (gridRow << grid.Shift);
  const double* top = &grid.Heights[static_cast<std::size_t>(gridRow) * grid.Width];
  const double* bottom = top + grid.Width;
  const double weights[2] = { static_cast<double>(v) / size, (v + 1.0) / size };
  for (int cell = 0; cell + 1 < grid.Width; ++cell)
  {
    const bool isMain = grid.IsMain(cell, gridRow);
    const int x = (cell << grid.Shift) + (isMain ? v : size - 1 - v);
    if (x + 1 < this->Reference.Width)
    {
      const double begin = isMain ? top[cell] : top[cell + 1];
      const double end = isMain ? bottom[cell + 1] : bottom[cell];
      const double first = begin + weights[0] * (end - begin) - reference[isMain ? x : x + 1];
      const double second = begin + weights[1] * (end - begin) - next[isMain ? x + 1 : x];
      RaiseTo(largest[x >> blockShift], this->GetDiagonalDistance(isMain, x, row, first, second));
    }
  }
}

double TriangleDistance::Measure(
  const std::array<Vertex, 3>& triangle, const ValueGrid<float>& offsets) const
{
  const auto [a, b, c] = triangle;
  const int x[2] = { std::max(0, std::min({ a.Column, b.Column, c.Column })),
    std::min(this->Reference.Width - 1, std::max({ a.Column, b.Column, c.Column })) };
  const int y[2] = { std::max(0, std::min({ a.Row, b.Row, c.Row })),
    std::min(this->Reference.Height - 1, std::max({ a.Row, b.Row, c.Row })) };
  const auto cross = [](const Vertex& p, const Vertex& q, int column, int row)
  { return (q.Column - p.Column) * (row - p.Row) - (q.Row - p.Row) * (column - p.Column); };
  const int area = cross(a, b, c.Column, c.Row);
  const int sign = area > 0 ? 1 : -1;
  const double share = 1.0 / area;
  struct Point
  {
    bool IsInside;
    double Distance;
  };
  std::array<std::array<Point, MaximumSide + 1>, 2> lines;
  double largest = -1.0;
  for (int row = y[0]; row <= y[1]; ++row)
  {
    std::array<Point, MaximumSide + 1>& line = lines[row % 2];
    for (int column = x[0]; column <= x[1]; ++column)
    {
      const int weights[3] = { cross(b, c, column, row), cross(c, a, column, row),
        cross(a, b, column, row) };
      Point& point = line[column - x[0]];
      point.IsInside = weights[0] * sign >= 0 && weights[1] * sign >= 0 && weights[2] * sign >= 0;
      if (point.IsInside)
      {
        double height = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          height += weights[i] != 0 ? weights[i] * triangle[i].Height : 0.0;
        }
        point.Distance = height * share - this->Reference.GetRow(row)[column];
      }
    }
    for (int column = x[0]; row > y[0] && column < x[1]; ++column)
    {
      const Point* top = &lines[(row - 1) % 2][column - x[0]];
      const Point* bottom = &line[column - x[0]];
      const Point* corners[4] = { top, top + 1, bottom, bottom + 1 };
      int inside = 0;
      double distance = -1.0;
      for (const Point* corner : corners)
      {
        if (corner->IsInside)
        {
          ++inside;
          RaiseTo(distance, std::abs(corner->Distance));
        }
      }
      if (inside == 3)
      {
        const bool isMain = top[0].IsInside && bottom[1].IsInside;
        RaiseTo(distance,
          isMain
            ? this->GetDiagonalDistance(true, column, row - 1, top[0].Distance, bottom[1].Distance)
            : this->GetDiagonalDistance(
                false, column, row - 1, top[1].Distance, bottom[0].Distance));
      }
      if (inside >= 3 && distance >= 0.0)
      {
        const double offset = offsets.Values.empty()
          ? 0.0
          : offsets.At(column >> ShiftOfBlocks, (row - 1) >> ShiftOfBlocks);
        RaiseTo(largest, distance + offset);
      }
    }
  }
  return largest;
}
}

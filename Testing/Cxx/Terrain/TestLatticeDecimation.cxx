// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of grids within a vertical tolerance: they cover the cells that have data once, without
// gaps, and all of their points are within the tolerance. Grids are smooth, or as rough as they can
// be.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoSanitizer.h"

#include "Bisection/LatticeDecimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{
using relevo::LatticeDecimation;
using Vertex = LatticeDecimation::Vertex;

enum class Kind
{
  Hills,
  Noise,
  Spikes,
  Checkerboard,
  Holes,
  Plane
};
constexpr int NumberOfKinds = 6;

struct Grid
{
  int Columns;
  int Rows;
  std::vector<float> Heights;

  float At(int column, int row) const
  {
    return this->Heights[static_cast<std::size_t>(row) * this->Columns + column];
  }
};

Grid MakeGrid(Kind kind, int columns, int rows, RelevoDice& dice)
{
  Grid grid{ columns, rows, {} };
  const double length = 3.0 + 10.0 * dice.Share();
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      double height = 20.0 * std::sin(column / length) * std::cos(row / length);
      if (kind == Kind::Noise)
      {
        height = 30.0 * dice.Signed();
      }
      else if (kind == Kind::Spikes)
      {
        height += dice.Once(40) ? 500.0 * dice.Signed() : 0.0;
      }
      else if (kind == Kind::Checkerboard)
      {
        height = (column + row) % 2 == 0 ? 50.0 : -50.0;
      }
      else if (kind == Kind::Holes)
      {
        height = dice.Once(30) || std::hypot(column - 12, row - 15) < 5.0
          ? std::numeric_limits<double>::quiet_NaN()
          : height;
      }
      else if (kind == Kind::Plane)
      {
        height = 3.0 * column - 2.0 * row;
      }
      grid.Heights.push_back(static_cast<float>(height));
    }
  }
  return grid;
}

std::int64_t GetDoubleArea(const LatticeDecimation::Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The triangles have the area of the cells with data, if none reach beyond the grid, and each edge
// inside of it has two triangles.
void CheckCovering(RelevoCheck& check, const LatticeDecimation& decimation, const Grid& grid,
  bool hasHoles, bool isWhole)
{
  using Edge = std::array<Vertex, 2>;
  std::vector<Edge> edges;
  std::int64_t area = 0;
  for (const LatticeDecimation::Triangle& triangle : decimation.GetTriangles())
  {
    const std::int64_t size = GetDoubleArea(triangle);
    CHECK(size != 0);
    area += std::abs(size);
    const auto& [a, b, c] = triangle;
    const Edge turned[3] = { { { a, b } }, { { b, c } }, { { c, a } } };
    for (const Edge& edge : turned)
    {
      edges.push_back(size > 0 ? edge : Edge{ { edge[1], edge[0] } });
    }
  }
  std::sort(edges.begin(), edges.end());
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  const std::int64_t unit = std::int64_t(1) << decimation.GetSubdivisions();
  if (isWhole)
  {
    std::int64_t cells = 0;
    for (int row = 0; row + 1 < grid.Rows; ++row)
    {
      for (int column = 0; column + 1 < grid.Columns; ++column)
      {
        cells += std::isnan(grid.At(column, row) + grid.At(column + 1, row) +
                   grid.At(column, row + 1) + grid.At(column + 1, row + 1))
          ? 0
          : 1;
      }
    }
    CHECK_EQUAL(area, 2 * cells * unit * unit);
  }
  const std::int64_t last[2] = { (grid.Columns - 1) * unit, (grid.Rows - 1) * unit };
  int gaps = 0;
  for (const Edge& edge : edges)
  {
    bool isOutside = false;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto ends = std::minmax(edge[0][axis], edge[1][axis]);
      isOutside = isOutside || ends.second == 0 || ends.first >= last[axis];
    }
    const Edge opposite = { { edge[1], edge[0] } };
    gaps += !isOutside && !std::binary_search(edges.begin(), edges.end(), opposite) ? 1 : 0;
  }
  CHECK(hasHoles || gaps == 0);
}

// The largest distance from the surface at points of the triangles and of their edges.
double MeasureDistance(const LatticeDecimation& decimation, const Grid& grid)
{
  constexpr int steps = 12;
  const double scale = std::ldexp(1.0, -decimation.GetSubdivisions());
  double largest = 0.0;
  for (const LatticeDecimation::Triangle& triangle : decimation.GetTriangles())
  {
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; i + j <= steps; ++j)
      {
        const double weights[3] = { static_cast<double>(steps - i - j) / steps,
          static_cast<double>(i) / steps, static_cast<double>(j) / steps };
        double point[3] = { 0.0, 0.0, 0.0 };
        for (int k = 0; k < 3; ++k)
        {
          point[0] += weights[k] * static_cast<double>(triangle[k][0]) * scale;
          point[1] += weights[k] * static_cast<double>(triangle[k][1]) * scale;
          point[2] += weights[k] * decimation.GetHeight(triangle[k]);
        }
        const int column = static_cast<int>(point[0]);
        const int row = static_cast<int>(point[1]);
        if (column + 1 >= grid.Columns || row + 1 >= grid.Rows)
        {
          continue; // beyond the grid, or on its last column or row
        }
        const double u = point[0] - column;
        const double v = point[1] - row;
        const double height =
          (1.0 - v) * ((1.0 - u) * grid.At(column, row) + u * grid.At(column + 1, row)) +
          v * ((1.0 - u) * grid.At(column, row + 1) + u * grid.At(column + 1, row + 1));
        const double distance = std::abs(point[2] - height);
        largest = distance > largest ? distance : largest; // false for NaN
      }
    }
  }
  return largest;
}

void TestGrids(RelevoCheck& check)
{
  for (int seed = 0; seed < (RelevoHasAddressSanitizer ? 2 : 16); ++seed)
  {
    RelevoDice dice(static_cast<unsigned int>(seed));
    for (int i = 0; i < NumberOfKinds; ++i)
    {
      CHECK_CASE(seed);
      CHECK_CASE(i);
      const Kind kind = static_cast<Kind>(i);
      const bool isWhole = seed % 2 == 0; // fills the square that is bisected
      const int columns = isWhole ? 33 : 20 + static_cast<int>(dice.Throw(30));
      const int rows = isWhole ? 33 : 20 + static_cast<int>(dice.Throw(30));
      const Grid grid = MakeGrid(kind, columns, rows, dice);
      LatticeDecimation decimation(grid.Heights, columns, rows);
      const double tolerance = std::exp2(3.0 * dice.Share());
      const auto result = decimation.Refine(tolerance, []() { return false; });
      CHECK(result == LatticeDecimation::Result::Done);
      CheckCovering(check, decimation, grid, kind == Kind::Holes, isWhole);
      const double distance = MeasureDistance(decimation, grid);
      CHECK_LESS_EQUAL(distance, tolerance * (1.0 + 1e-9) + 1e-4); // planes have rounded heights
      CHECK(kind == Kind::Plane || kind == Kind::Holes || distance > 0.3 * tolerance);
      if (kind == Kind::Plane && isWhole)
      {
        CHECK_EQUAL(decimation.GetTriangles().size(), 2);
      }
    }
  }
}

// Right triangles alone would need many more; see the comparison with the number of cells.
void TestNumbers(RelevoCheck& check)
{
  RelevoDice dice(1);
  constexpr int size = 257;
  const Grid grid = MakeGrid(Kind::Hills, size, size, dice);
  std::size_t numbers[2];
  for (int i = 0; i < 2; ++i)
  {
    LatticeDecimation decimation(grid.Heights, size, size);
    CHECK(decimation.Refine(i == 0 ? 1.0 : 4.0, []() { return false; }) ==
      LatticeDecimation::Result::Done);
    numbers[i] = decimation.GetTriangles().size();
  }
  CHECK_LESS(2 * numbers[1], numbers[0]);
  CHECK_LESS(4 * numbers[0], 2 * size * size);

  LatticeDecimation aborted(grid.Heights, size, size);
  CHECK(aborted.Refine(1.0, []() { return true; }) == LatticeDecimation::Result::Aborted);
  LatticeDecimation impossible(grid.Heights, size, size);
  CHECK(
    impossible.Refine(1e-9, []() { return false; }) == LatticeDecimation::Result::TooManyTriangles);
}
}

int TestLatticeDecimation(int, char*[])
{
  RelevoCheck check;
  TestGrids(check);
  TestNumbers(check);
  return check.GetResult();
}

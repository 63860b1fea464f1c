// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/BlockErrorArea.h"

#include "Lattice/BlockErrors.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
constexpr int CellsPerBlock = BlockErrors::CellsPerBlock;
constexpr int ShiftPerBlock = 3;
static_assert(CellsPerBlock == 1 << ShiftPerBlock, "shift and size must agree");

// Missing data are worth this share of the spacing of vertices.
constexpr double OutlineShare = 0.25;

// Comparisons with NaN are false.
template <typename T>
void Raise(T& largest, T value)
{
  largest = value > largest ? value : largest;
}

float RoundUpToFloat(double value)
{
  const auto rounded = static_cast<float>(value);
  return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                         : rounded;
}

void ExtendRange(BlockErrorArea::Range& range, float height)
{
  if (!std::isnan(height))
  {
    range[0] = range[0] < height ? range[0] : height;
    range[1] = range[1] > height ? range[1] : height;
  }
}

// Whether the vertices of each block of 8 x 8 cells have data; blocks share their border.
template <typename T>
void AddContents(const ValueGrid<T>& heights, ValueGrid<std::uint8_t>& contents)
{
  const auto isMissing = [](T height) { return std::isnan(height); };
  const bool hasMissing = std::any_of(heights.Values.begin(), heights.Values.end(), isMissing);
  const bool hasData =
    !hasMissing || !std::all_of(heights.Values.begin(), heights.Values.end(), isMissing);
  if (!hasMissing || !hasData)
  {
    for (std::uint8_t& block : contents.Values)
    {
      block |= hasData ? BlockErrorArea::HasData : BlockErrorArea::HasMissing;
    }
    return;
  }
  for (int j = 0; j < heights.Height; ++j)
  {
    const T* row = heights.GetRow(j);
    for (int i = 0; i < heights.Width; ++i)
    {
      const std::uint8_t flag =
        isMissing(row[i]) ? BlockErrorArea::HasMissing : BlockErrorArea::HasData;
      for (int y = std::max(j - 1, 0) / CellsPerBlock;
           y <= std::min(j / CellsPerBlock, contents.Height - 1); ++y)
      {
        for (int x = std::max(i - 1, 0) / CellsPerBlock;
             x <= std::min(i / CellsPerBlock, contents.Width - 1); ++x)
        {
          contents.At(x, y) |= flag;
        }
      }
    }
  }
}

bool IsMixed(std::uint8_t contents)
{
  return contents == (BlockErrorArea::HasData | BlockErrorArea::HasMissing);
}
}

BlockErrorArea::BlockErrorArea(int baseLevel, int firstColumn, int firstRow, int width, int height)
  : BaseLevel(baseLevel)
  , First{ { firstColumn, firstRow } }
  , Size{ { width, height } }
  , Reference(width, height)
{
}

std::array<int, 2> BlockErrorArea::GetFirstVertex(int level) const
{
  const int shift = level - this->BaseLevel;
  return { { this->First[0] >> shift, this->First[1] >> shift } };
}

std::array<int, 2> BlockErrorArea::GetNumberOfVertices(int level) const
{
  const int shift = level - this->BaseLevel;
  const auto count = [shift](int size) { return ((size - 2 + (1 << shift)) >> shift) + 1; };
  return { { count(this->Size[0]), count(this->Size[1]) } };
}

std::array<int, 2> BlockErrorArea::GetNumberOfBlocks(int level) const
{
  const std::array<int, 2> vertices = this->GetNumberOfVertices(level);
  const auto count = [](int size) { return (size - 2 + CellsPerBlock) / CellsPerBlock; };
  return { { count(vertices[0]), count(vertices[1]) } };
}

void BlockErrorArea::ThinHeights(int level)
{
  const ValueGrid<float>& fine = this->GetLevel(level - 1).Heights;
  const std::array<int, 2> size = this->GetNumberOfVertices(level);
  ValueGrid<float> heights(size[0], size[1]);
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      heights.At(i, j) = fine.GetNearest(2 * i, 2 * j);
    }
  }
  this->GetLevel(level).Heights = std::move(heights);
}

void BlockErrorArea::Measure(int lastLevel, double sampleDistance)
{
  if (this->BaseLevel == 0)
  {
    this->MeasureFullResolution(sampleDistance);
  }
  for (int level = this->BaseLevel + 1; level <= lastLevel; ++level)
  {
    this->MeasureLevel(level, sampleDistance);
  }
}

// At level 0, the faces of a square differ from the bilinear cells by a quarter of their twist.
void BlockErrorArea::MeasureFullResolution(double sampleDistance)
{
  const ValueGrid<double>& heights = this->Reference;
  Level& result = this->Levels[0];
  const std::array<int, 2> blocks = this->GetNumberOfBlocks(0);
  result.Contents = ValueGrid<std::uint8_t>(blocks[0], blocks[1], 0);
  AddContents(heights, result.Contents);
  this->MergeCorners(0);

  constexpr int size = 2 * CellsPerBlock;
  result.Square = ValueGrid<float>((blocks[0] + 1) / 2, (blocks[1] + 1) / 2, 0.0f);
  struct Largest
  {
    double Twist = 0.0;
    double Rounding = 0.0;
  };
  std::vector<Largest> largest(result.Square.Width); // in a row of pairs of blocks
  const auto measureRow = [&](int y, bool isLast)
  {
    const double* row = heights.GetRow(y);
    const double* after = y + 1 < heights.Height ? row + heights.Width : row;
    for (int pair = 0; pair < result.Square.Width; ++pair)
    {
      Largest& found = largest[pair];
      const int end = std::min((pair + 1) * size, heights.Width - 1);
      for (int x = pair * size; x <= end; ++x)
      {
        Raise(found.Rounding, std::abs(static_cast<double>(static_cast<float>(row[x])) - row[x]));
        if (x < end && !isLast)
        {
          Raise(found.Twist, std::abs(row[x] + after[x + 1] - row[x + 1] - after[x]));
        }
      }
    }
  };
  for (int pairRow = 0; pairRow < result.Square.Height; ++pairRow)
  {
    std::fill(largest.begin(), largest.end(), Largest());
    const int last = std::min((pairRow + 1) * size, heights.Height - 1);
    for (int y = pairRow * size; y < last; ++y)
    {
      measureRow(y, false);
    }
    measureRow(last, true);
    for (int pair = 0; pair < result.Square.Width; ++pair)
    {
      const Largest& found = largest[pair];
      double error = 0.25 * found.Twist + found.Rounding / BlockErrors::EdgeShareOfLevel0;
      for (int block = 0; block < 4; ++block)
      {
        const int column = 2 * pair + block % 2;
        const int row = 2 * pairRow + block / 2;
        if (column < blocks[0] && row < blocks[1] && IsMixed(result.Contents.At(column, row)))
        {
          Raise(error, OutlineShare * sampleDistance);
        }
      }
      result.Square.At(pair, pairRow) = RoundUpToFloat(error);
    }
  }
}

void BlockErrorArea::MeasureLevel(int level, double sampleDistance)
{
  Level& result = this->GetLevel(level);
  this->MergeContents(level);
  this->MergeCorners(level);
  const TriangulatedGrid squares = this->MakeSquares(level);
  const TriangulatedGrid faces = this->MakeFaces(level);
  result.Bases = this->MeasureSquares(squares, level);
  result.Square = result.Bases;
  result.Faces = this->MeasureFaces(faces, level);
  const auto outline = static_cast<float>(OutlineShare * std::ldexp(sampleDistance, level));
  for (int row = 0; row < result.Square.Height; ++row)
  {
    for (int column = 0; column < result.Square.Width; ++column)
    {
      float& square = result.Square.At(column, row);
      Sides& sides = result.Faces.At(column, row);
      Raise(square, this->MeasureSquareCorners(squares, column, row));
      this->RaiseFaceCorners(faces, column, row, sides);
      if (IsMixed(result.Contents.At(column, row)))
      {
        Raise(square, outline);
        for (float& face : sides)
        {
          Raise(face, outline);
        }
      }
    }
  }
}

void BlockErrorArea::MergeContents(int level)
{
  const ValueGrid<std::uint8_t>& fine = this->GetLevel(level - 1).Contents;
  const std::array<int, 2> blocks = this->GetNumberOfBlocks(level);
  ValueGrid<std::uint8_t> contents(blocks[0], blocks[1], 0);
  for (int row = 0; row < fine.Height; ++row)
  {
    for (int column = 0; column < fine.Width; ++column)
    {
      contents.At(column / 2, row / 2) |= fine.At(column, row);
    }
  }
  AddContents(this->GetLevel(level).Heights, contents);
  this->GetLevel(level).Contents = std::move(contents);
}

// Adds the heights of the level to the ranges of corners of the finer level, if there is one.
void BlockErrorArea::MergeCorners(int level)
{
  const ValueGrid<float>& heights = this->GetLevel(level).Heights;
  const std::array<int, 2> blocks = this->GetNumberOfBlocks(level);
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  ValueGrid<Range> corners(blocks[0] + 1, blocks[1] + 1, { { missing, missing } });
  for (int row = 0; row < corners.Height; ++row)
  {
    for (int column = 0; column < corners.Width; ++column)
    {
      Range& range = corners.At(column, row);
      if (level > this->BaseLevel)
      {
        range = this->GetLevel(level - 1).Corners.GetNearest(2 * column, 2 * row);
      }
      ExtendRange(range, heights.GetNearest(CellsPerBlock * column, CellsPerBlock * row));
    }
  }
  this->GetLevel(level).Corners = std::move(corners);
}

// The faces of squares that are not split.
TriangulatedGrid BlockErrorArea::MakeSquares(int level) const
{
  const ValueGrid<float>& heights = this->Levels[level - this->BaseLevel].Heights;
  TriangulatedGrid grid;
  grid.Shift = level - this->BaseLevel;
  grid.Width = heights.Width;
  grid.Height = heights.Height;
  grid.Heights.assign(heights.Values.begin(), heights.Values.end());
  grid.FirstCell = this->GetFirstVertex(level);
  return grid;
}

/*
 * The faces of split squares, on the lattice of the finer level. Their vertices are those where the
 * sum of column and row is even. Each of the others lies in the middle of an edge of the coarser
 * lattice.
 */
TriangulatedGrid BlockErrorArea::MakeFaces(int level) const
{
  const ValueGrid<float>& coarse = this->Levels[level - this->BaseLevel].Heights;
  const ValueGrid<float>& fine = this->Levels[level - this->BaseLevel - 1].Heights;
  TriangulatedGrid grid;
  grid.Shift = level - this->BaseLevel - 1;
  grid.Width = 2 * coarse.Width - 1;
  grid.Height = 2 * coarse.Height - 1;
  grid.Heights.resize(static_cast<std::size_t>(grid.Width) * grid.Height);
  constexpr int size = 2 * CellsPerBlock;
  const auto getVertex = [&](int i, int j) -> double
  {
    return i % size == 0 || j % size == 0 ? coarse.GetNearest(i / 2, j / 2) : fine.GetNearest(i, j);
  };
  double* height = grid.Heights.data();
  for (int j = 0; j < grid.Height; ++j)
  {
    for (int i = 0; i < grid.Width; ++i, ++height)
    {
      if ((i + j) % 2 == 0)
      {
        *height = getVertex(i, j);
        continue;
      }
      const int x = i % 2;
      const int y = j % 2;
      *height = 0.5 * (getVertex(i - x, j - y) + getVertex(i + x, j + y));
    }
  }
  return grid;
}

ValueGrid<float> BlockErrorArea::MeasureSquares(const TriangulatedGrid& grid, int level) const
{
  TriangleDistance distance(this->Reference);
  const std::array<int, 2> blocks = this->GetNumberOfBlocks(level);
  const int shift = level - this->BaseLevel;
  ValueGrid<float> result(blocks[0], blocks[1], 0.0f);
  if (this->BaseLevel == 0)
  {
    const ValueGrid<double> measured = distance.Measure(grid, shift + ShiftPerBlock);
    std::transform(measured.Values.begin(), measured.Values.end(), result.Values.begin(),
      [](double one) { return RoundUpToFloat(std::max(one, 0.0)); });
    return result;
  }
  distance.SetTriangulated(this->First);
  const ValueGrid<double> measured = distance.Measure(grid, ShiftPerBlock);
  for (int row = 0; row < measured.Height; ++row)
  {
    for (int column = 0; column < measured.Width; ++column)
    {
      const double one = measured.At(column, row);
      Raise(result.At(column >> shift, row >> shift),
        one < 0.0 ? 0.0f : RoundUpToFloat(one + this->Levels[0].Bases.At(column, row)));
    }
  }
  return result;
}

ValueGrid<BlockErrorArea::Sides> BlockErrorArea::MeasureFaces(
  const TriangulatedGrid& grid, int level) const
{
  TriangleDistance distance(this->Reference);
  const std::array<int, 2> blocks = this->GetNumberOfBlocks(level);
  const int shift = level - this->BaseLevel;
  ValueGrid<Sides> result(blocks[0], blocks[1], Sides{});
  if (this->BaseLevel == 0)
  {
    const ValueGrid<TriangleDistance::Sides> measured =
      distance.MeasureSides(grid, shift + ShiftPerBlock);
    for (std::size_t i = 0; i < measured.Values.size(); ++i)
    {
      std::transform(measured.Values[i].begin(), measured.Values[i].end(), result.Values[i].begin(),
        [](double one) { return RoundUpToFloat(std::max(one, 0.0)); });
    }
    return result;
  }
  distance.SetTriangulated(this->First);
  const ValueGrid<double> measured = distance.Measure(grid, ShiftPerBlock);
  const int size = 1 << shift;
  for (int row = 0; row < measured.Height; ++row)
  {
    for (int column = 0; column < measured.Width; ++column)
    {
      const double one = measured.At(column, row);
      const float error =
        one < 0.0 ? 0.0f : RoundUpToFloat(one + this->Levels[0].Bases.At(column, row));
      Sides& sides = result.At(column >> shift, row >> shift);
      TriangleDistance::ForSides(
        column & (size - 1), row & (size - 1), size, [&](int side) { Raise(sides[side], error); });
    }
  }
  return result;
}

// The triangles at the corners of an unsplit square, with the heights of finer lattices.
float BlockErrorArea::MeasureSquareCorners(const TriangulatedGrid& grid, int column, int row) const
{
  float largest = 0.0f;
  for (int corner = 0; corner < 4; ++corner)
  {
    const int right = corner % 2;
    const int lower = corner / 2;
    const Range& range = this->Levels[grid.Shift].Corners.At(column + right, row + lower);
    const Position at = { CellsPerBlock * (column + right), CellsPerBlock * (row + lower) };
    const int x = right ? -1 : 1;
    const int y = lower ? -1 : 1;
    Raise(largest, this->MeasureCorner(grid, range, { { at, { x, 0 }, { x, y } } }));
    Raise(largest, this->MeasureCorner(grid, range, { { at, { 0, y }, { x, y } } }));
  }
  return largest;
}

// The triangles at the corners of the faces of a split square: those of the block and its centre.
void BlockErrorArea::RaiseFaceCorners(
  const TriangulatedGrid& grid, int column, int row, Sides& sides) const
{
  const Range& centers = this->Levels[grid.Shift].Corners.At(2 * column + 1, 2 * row + 1);
  const Position center = { CellsPerBlock * (2 * column + 1), CellsPerBlock * (2 * row + 1) };
  for (int corner = 0; corner < 4; ++corner)
  {
    const int right = corner % 2;
    const int lower = corner / 2;
    const Range& range = this->Levels[grid.Shift + 1].Corners.At(column + right, row + lower);
    const Position at = { 2 * CellsPerBlock * (column + right), 2 * CellsPerBlock * (row + lower) };
    const int x = right ? -1 : 1;
    const int y = lower ? -1 : 1;
    float& rowSide = sides[lower ? 2 : 0];
    float& columnSide = sides[right ? 1 : 3];
    Raise(rowSide, this->MeasureCorner(grid, range, { { at, { x, y }, { 2 * x, 0 } } }));
    Raise(columnSide, this->MeasureCorner(grid, range, { { at, { x, y }, { 0, 2 * y } } }));
    Raise(
      columnSide, this->MeasureCorner(grid, centers, { { center, { -x, -y }, { -2 * x, 0 } } }));
    Raise(rowSide, this->MeasureCorner(grid, centers, { { center, { -x, -y }, { 0, -2 * y } } }));
  }
}

// A triangle between a corner and two vertices that are given relative to it.
float BlockErrorArea::MeasureCorner(
  const TriangulatedGrid& grid, const Range& range, const std::array<Position, 3>& vertices) const
{
  std::array<TriangleDistance::Vertex, 3> triangle;
  for (int i = 0; i < 3; ++i)
  {
    const int column = vertices[i].Column + (i > 0 ? vertices[0].Column : 0);
    const int row = vertices[i].Row + (i > 0 ? vertices[0].Row : 0);
    const std::size_t at = static_cast<std::size_t>(std::min(row, grid.Height - 1)) * grid.Width +
      std::min(column, grid.Width - 1);
    triangle[i] = { column << grid.Shift, row << grid.Shift, grid.Heights[at] };
  }
  float largest = 0.0f;
  const double known = triangle[0].Height;
  double last = known;
  for (const float height : range)
  {
    triangle[0].Height = height;
    if (height != known && height != last) // measured already
    {
      TriangleDistance distance(this->Reference);
      if (this->BaseLevel > 0)
      {
        distance.SetTriangulated(this->First);
      }
      Raise(largest, RoundUpToFloat(distance.Measure(triangle, this->Levels[0].Bases)));
      last = height;
    }
  }
  return largest;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/TerrainDivision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <iterator>
#include <numeric>
#include <utility>

namespace relevo
{
namespace
{
constexpr std::size_t MostLeaves = 8192;

// Blocks of finer levels are parts of one cell of the raster.
constexpr int FinestLeafLevel = -3;

// A range of heights as large as a block.
constexpr int LevelsToTile = 5;
}

TerrainDivision::TerrainDivision(
  const std::array<int, 2>& dimensions, const BlockErrors& errors, const ElevationRanges& ranges)
  : Dimensions(dimensions)
  , Errors(errors)
  , Ranges(ranges)
{
}

// Coarse blocks are split first, so that the largest number of leaves is spread over the view.
void TerrainDivision::FindLeaves(const TerrainView& view, double tolerance)
{
  struct Block
  {
    int Level;
    std::int64_t Column;
    std::int64_t Row;
  };
  this->Found.clear();
  std::deque<Block> blocks = {
    { BlockErrors::GetRootLevel(this->Dimensions[0], this->Dimensions[1]), 0, 0 }
  };
  while (!blocks.empty())
  {
    const Block block = blocks.front();
    blocks.pop_front();
    const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), block.Level);
    TerrainBox box;
    box.Columns = { { static_cast<double>(block.Column) * size,
      std::min((static_cast<double>(block.Column) + 1.0) * size, this->Dimensions[0] - 1.0) } };
    box.Rows = { { static_cast<double>(block.Row) * size,
      std::min((static_cast<double>(block.Row) + 1.0) * size, this->Dimensions[1] - 1.0) } };
    if (box.Columns[0] >= box.Columns[1] || box.Rows[0] >= box.Rows[1])
    {
      continue;
    }
    const ElevationRanges::Range heights =
      this->Ranges.Get(block.Level - LevelsToTile, box.Columns, box.Rows);
    box.Heights = { { heights[0], heights[1] } };
    if (box.Heights[0] > box.Heights[1] || !view.IsVisible(box))
    {
      continue;
    }
    const double error = this->Errors.GetSquareError(block.Level, static_cast<int>(block.Column),
                           static_cast<int>(block.Row)) +
      view.GetShapeError(block.Level, true, box);
    const double pixels = view.Project(error, box);
    if (block.Level > FinestLeafLevel && this->Found.size() + blocks.size() + 4 <= MostLeaves &&
      pixels > tolerance)
    {
      for (int i = 0; i < 4; ++i)
      {
        blocks.push_back({ block.Level - 1, 2 * block.Column + i % 2, 2 * block.Row + i / 2 });
      }
      continue;
    }
    // The error of a block is at least in proportion to its area.
    const double weight = std::isfinite(pixels) ? std::max(1.0, pixels / tolerance) : 1.0;
    this->Found.push_back({ { { box.Columns, box.Rows } }, weight });
  }
}

void TerrainDivision::Split(
  Leaves leaves, const TerrainShare& whole, int number, std::vector<TerrainShare>& shares)
{
  if (number == 1)
  {
    shares.push_back(whole);
    return;
  }
  std::array<Range, 2> all = leaves.empty() ? std::array<Range, 2>{} : leaves.front().Sides;
  for (const Leaf& leaf : leaves)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      all[axis] = { { std::min(all[axis][0], leaf.Sides[axis][0]),
        std::max(all[axis][1], leaf.Sides[axis][1]) } };
    }
  }
  const int axis = all[0][1] - all[0][0] >= all[1][1] - all[1][0] ? 0 : 1;
  std::sort(leaves.begin(), leaves.end(),
    [axis](const Leaf& a, const Leaf& b)
    {
      return a.Sides[axis] != b.Sides[axis] ? a.Sides[axis] < b.Sides[axis]
                                            : a.Sides[1 - axis] < b.Sides[1 - axis];
    });
  const int first = number / 2;
  const auto add = [](double sum, const Leaf& leaf) { return sum + leaf.Weight; };
  double rest = std::accumulate(leaves.begin(), leaves.end(), 0.0, add) * first / number;
  auto place = leaves.begin();
  for (; place != leaves.end() && rest > 0.0; ++place)
  {
    rest -= place->Weight;
  }
  double cut = place != leaves.end() ? place->Sides[axis][0] : 0.0;
  if (!(cut > all[axis][0] && cut < all[axis][1]))
  {
    cut = 0.5 * (all[axis][0] + all[axis][1]); // few leaves
  }
  TerrainShare parts[2] = { whole, whole };
  (axis == 0 ? parts[0].Columns : parts[0].Rows)[1] = cut;
  (axis == 0 ? parts[1].Columns : parts[1].Rows)[0] = cut;
  for (int part = 0; part < 2; ++part)
  {
    Leaves own;
    std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(own),
      [axis, cut, part](const Leaf& leaf)
      { return (0.5 * (leaf.Sides[axis][0] + leaf.Sides[axis][1]) < cut) == (part == 0); });
    Split(std::move(own), parts[part], part == 0 ? first : number - first, shares);
  }
}

std::vector<TerrainShare> TerrainDivision::Divide(
  const TerrainView& view, double tolerance, int number)
{
  this->FindLeaves(view, tolerance);
  std::vector<TerrainShare> shares;
  Split(this->Found, TerrainShare(), number, shares);
  return shares;
}
}

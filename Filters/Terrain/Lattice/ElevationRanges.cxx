// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/ElevationRanges.h"

#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr float InfiniteHeight = std::numeric_limits<float>::infinity();

void Extend(ElevationRanges::Range& range, const ElevationRanges::Range& other)
{
  range[0] = std::min(range[0], other[0]);
  range[1] = std::max(range[1], other[1]);
}
}

ElevationRanges::ElevationRanges(const Range& all)
  : All(all)
{
}

void ElevationRanges::AddTile(int column, int row, const Range& range)
{
  if (range[0] <= range[1])
  {
    this->Levels.resize(1);
    this->Levels[0][MakeGridKey(column, row)] = range;
  }
}

void ElevationRanges::Finish()
{
  // Up to the tile that covers the raster. With fewer levels, Get() would visit many small tiles of
  // a sparse raster.
  while (!this->Levels.empty() &&
    (this->Levels.back().size() > 1 || this->Levels.back().begin()->first != 0))
  {
    Tiles coarser;
    for (const auto& [key, range] : this->Levels.back())
    {
      const std::uint64_t parent = MakeGridKey(GetKeyColumn(key) / 2, GetKeyRow(key) / 2);
      Extend(coarser.emplace(parent, range).first->second, range);
    }
    this->Levels.push_back(std::move(coarser));
  }
}

ElevationRanges::Range ElevationRanges::Get(
  int level, const std::array<double, 2>& columns, const std::array<double, 2>& rows) const
{
  if (this->Levels.empty())
  {
    return this->All;
  }
  const int last = static_cast<int>(this->Levels.size()) - 1;
  const Tiles& tiles = this->Levels[std::clamp(level, 0, last)];
  const double size = std::ldexp(static_cast<double>(SamplesPerTile), std::clamp(level, 0, last));
  const auto find = [size](
                      const std::array<double, 2>& range, std::int64_t& first, std::int64_t& end)
  {
    first = static_cast<std::int64_t>(std::floor(std::max(0.0, range[0])) / size);
    end = static_cast<std::int64_t>(std::ceil(std::max(0.0, range[1])) / size);
  };
  std::int64_t c[2];
  std::int64_t r[2];
  find(columns, c[0], c[1]);
  find(rows, r[0], r[1]);
  Range range = { { InfiniteHeight, -InfiniteHeight } };
  if (this->Absent[0] <= this->Absent[1])
  {
    range = this->Absent;
  }
  for (std::int64_t row = r[0]; row <= r[1]; ++row)
  {
    for (std::int64_t column = c[0]; column <= c[1]; ++column)
    {
      const auto found = tiles.find(MakeGridKey(column, row));
      if (found != tiles.end())
      {
        Extend(range, found->second);
      }
    }
  }
  return range;
}
}

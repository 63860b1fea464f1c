// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/ClosedLattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace relevo
{
namespace
{
constexpr float MissingPole = std::numeric_limits<float>::quiet_NaN();

// Samples of the row next to a pole.
constexpr int LargestRow = 512;

// Sampled rows can have larger errors.
constexpr double PoleMargin = 1.5;
}

ClosedLattice::ClosedLattice(
  std::shared_ptr<const HeightLattice> lattice, std::shared_ptr<const GlobeShape> shape)
  : Lattice(std::move(lattice))
  , Shape(std::move(shape))
  , Poles{ { MissingPole, MissingPole } }
{
  if (this->Shape->GetPeriod() > 0 && this->Shape->HasFirstPole())
  {
    this->ReadPole(0);
  }
  if (this->Shape->GetPeriod() > 0 && this->Shape->HasLastPole())
  {
    this->ReadPole(1);
  }
}

// Without heights, or if they cannot be read, there is no pole. Tiles report the error.
void ClosedLattice::ReadPole(int pole)
{
  const int period = this->Shape->GetPeriod();
  int level = 0;
  while ((period >> level) > LargestRow)
  {
    ++level;
  }
  const int number = ((period - 1) >> level) + 1;
  const int last = this->Lattice->Describe().Height - 1;
  std::vector<float> heights(number);
  std::string error;
  if (!this->Lattice->ReadWindow(
        level, 0, pole == 0 ? 0 : ((last - 1) >> level) + 1, number, 1, heights.data(), error))
  {
    return;
  }
  double sum = 0.0;
  int count = 0;
  for (float height : heights)
  {
    sum += std::isnan(height) ? 0.0 : height;
    count += std::isnan(height) ? 0 : 1;
  }
  if (count == 0)
  {
    return;
  }
  this->Poles[pole] = static_cast<float>(sum / count);
  for (float height : heights)
  {
    const double distance = PoleMargin * std::abs(height - this->Poles[pole]);
    this->PoleErrors[pole] =
      std::max(this->PoleErrors[pole], std::isnan(distance) ? 0.0 : distance);
  }
}

bool ClosedLattice::Read(HeightTile& tile, std::string& error) const
{
  if (!this->Lattice->Read(tile, error) || !this->CloseColumns(tile, error))
  {
    return false;
  }
  this->ClosePoles(tile);
  return true;
}

bool ClosedLattice::CloseColumns(HeightTile& tile, std::string& error) const
{
  const int period = this->Shape->GetPeriod();
  const std::int64_t step = std::int64_t(1) << tile.Level;
  const std::int64_t first = static_cast<std::int64_t>(tile.Column) * HeightTile::CellsPerTile - 1;
  const int firstRow = tile.Row * HeightTile::CellsPerTile - 1;
  std::vector<float> columns(2 * HeightTile::Stride);
  for (int i = 0; i < HeightTile::Stride && period > 0; ++i)
  {
    const std::int64_t sample = (first + i) * step;
    if ((sample >= 0 && sample < period) || sample > period + 1 + 2 * step)
    {
      continue;
    }
    // Samples of the first columns are between vertices, in general.
    const std::int64_t repeated = (sample % period + period) % period;
    const auto column = static_cast<int>(repeated / step);
    const float weight = static_cast<float>(repeated % step) / static_cast<float>(step);
    if (!this->Lattice->ReadWindow(
          tile.Level, column, firstRow, 2, HeightTile::Stride, columns.data(), error))
    {
      return false;
    }
    for (int row = 0; row < HeightTile::Stride; ++row)
    {
      const float left = columns[2 * row];
      const float right = columns[2 * row + 1];
      // Vertices without weight may lack data.
      tile.Heights[row * HeightTile::Stride + i] =
        weight > 0.0f ? left + weight * (right - left) : left;
    }
  }
  return true;
}

void ClosedLattice::ClosePoles(HeightTile& tile) const
{
  const std::int64_t step = std::int64_t(1) << tile.Level;
  const std::int64_t first = static_cast<std::int64_t>(tile.Row) * HeightTile::CellsPerTile - 1;
  const double end = this->Shape->GetEnd()[1];
  for (int j = 0; j < HeightTile::Stride; ++j)
  {
    float* row = tile.Heights.data() + static_cast<std::ptrdiff_t>(j) * HeightTile::Stride;
    const double sample = static_cast<double>((first + j) * step);
    if (!std::isnan(this->Poles[0]) && sample <= 0.0)
    {
      std::fill_n(row, HeightTile::Stride, this->Poles[0]);
    }
    else if (!std::isnan(this->Poles[1]) && sample >= end)
    {
      std::fill_n(row, HeightTile::Stride, this->Poles[1]);
    }
  }
}
}

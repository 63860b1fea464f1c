// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/BlockErrors.h"

#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Triangles of finer levels lie within bilinear cells, so that errors are proportional to areas.
float GetShareOfLevel0(int level)
{
  return std::ldexp(1.0f, 2 * level);
}

float Decode(int code, float largest)
{
  return code == 0 ? 0.0f
                   : largest *
      std::exp2(static_cast<float>(code - BlockErrors::LargestCode) / BlockErrors::StepsPerOctave);
}
}

BlockErrors::BlockErrors(int rootLevel)
  : Levels(rootLevel + 1)
{
}

BlockErrors BlockErrors::Estimate(int rootLevel, float squareErrorOfLevel0)
{
  BlockErrors errors(rootLevel);
  errors.Estimated = squareErrorOfLevel0;
  return errors;
}

int BlockErrors::GetRootLevel(int columns, int rows)
{
  // Faces need two levels of heights, so that the root has at least level 1.
  int level = 1;
  while ((static_cast<std::int64_t>(CellsPerBlock) << level) < std::max(columns, rows) - 1)
  {
    ++level;
  }
  return level;
}

float BlockErrors::Find(int level, int column, int row, int kind) const
{
  if (level >= static_cast<int>(this->Levels.size()))
  {
    return this->Largest;
  }
  const Tiles& tiles = this->Levels[level];
  const auto found = tiles.find(MakeGridKey(column / BlocksPerTile, row / BlocksPerTile));
  if (found == tiles.end())
  {
    return 0.0f;
  }
  const int block = row % BlocksPerTile * BlocksPerTile + column % BlocksPerTile;
  return Decode(found->second[kind][block], this->Largest);
}

// The saturated error of a block of a level up to 0, in units of level 0.
float BlockErrors::FindSaturated(int level, int column, int row, int neighbors) const
{
  const int shift = 1 - level;
  float largest = 0.0f;
  for (int y = std::max(row - neighbors, 0) >> shift; y <= (row + neighbors) >> shift; ++y)
  {
    for (int x = std::max(column - neighbors, 0) >> shift; x <= (column + neighbors) >> shift; ++x)
    {
      largest = std::max(largest, this->Find(0, x, y, Square));
    }
  }
  return std::max(
    this->Find(0, column >> shift, row >> shift, Square), NeighborShareOfLevel0 * largest);
}

float BlockErrors::GetSquareError(int level, int column, int row) const
{
  if (this->Estimated > 0.0f)
  {
    return this->Estimated * std::exp2(static_cast<float>(level > 0 ? level : 2 * level));
  }
  // The errors of the edges of this level depend on one block around the two at the edge.
  return level > 0 ? this->Find(level, column, row, Square)
                   : GetShareOfLevel0(level) * this->FindSaturated(level, column, row, 2);
}

float BlockErrors::GetEdgeError(int level, int column, int row, int axis) const
{
  if (this->Estimated > 0.0f)
  {
    return this->GetSquareError(level, column, row) *
      (level > 0 ? std::sqrt(0.5f) : EdgeShareOfLevel0);
  }
  if (level > 0)
  {
    return this->Find(level, column, row, RowEdge + axis);
  }
  // The square errors of the finer level depend on two of its blocks around, which are one of this.
  const float errors[2] = { this->FindSaturated(level, column, row, 1),
    this->FindSaturated(level, std::max(column - axis, 0), std::max(row - 1 + axis, 0), 1) };
  return EdgeShareOfLevel0 * GetShareOfLevel0(level) * std::max(errors[0], errors[1]);
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/MipmapTiles.h"

#include "Lattice/BlockErrors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// The size in pixels of a step between samples from which on the next finer level is needed.
// Fragments whose step is smaller than 1.2 pixels do not use it; see relevoFirstLevel() in
// relevoTerrainTiles.glsl. Pixels are smaller away from the centre of a perspective view.
constexpr double LargestStep = 0.9;
}

MipmapTiles::MipmapTiles(int columns, int rows, const ElevationRanges& ranges)
  : Columns(columns)
  , Rows(rows)
  , Ranges(ranges)
{
}

void MipmapTiles::Start(const TerrainView& view, double largestError)
{
  this->View = &view;
  this->LargestError = largestError;
  this->Tiles.clear();
  this->Complete = true;
}

void MipmapTiles::Select(const TerrainView& view, double largestError, HeightTileSource& tiles)
{
  this->Start(view, largestError);
  this->Imagery = nullptr;
  this->FinestLevel = 0;
  this->Find = [&tiles](int level, int column, int row, double error, float& visibility)
  { return tiles.Get(level, column, row, error, visibility); };
  this->Visit(BlockErrors::GetRootLevel(this->Columns, this->Rows), 0, 0, 1.0);
}

void MipmapTiles::SelectImagery(
  const TerrainView& view, const ImageryLattice& imagery, ImageryTileSource& tiles)
{
  this->Start(view, 0.0);
  this->Imagery = &imagery;
  this->FinestLevel = imagery.GetFinestLevel();
  this->Find = [&tiles](int level, int column, int row, double error, float& visibility)
  { return tiles.GetImagery(level, column, row, error, visibility); };
  // One tile covers the raster.
  int level = 0;
  while (std::ldexp(static_cast<double>(TerrainTile::CellsPerTile), level) <
    std::max(this->Columns, this->Rows) - 1)
  {
    ++level;
  }
  this->Visit(level, 0, 0, std::numeric_limits<double>::infinity());
}

// `pixels` is the size of a step of this level, of at most 1 pixel for fragments that need no finer
// level.
void MipmapTiles::Visit(int level, int column, int row, double pixels)
{
  const double size = std::ldexp(static_cast<double>(TerrainTile::CellsPerTile), level);
  TerrainBox box;
  box.Columns = { { column * size, std::min((column + 1.0) * size, this->Columns - 1.0) } };
  box.Rows = { { row * size, std::min((row + 1.0) * size, this->Rows - 1.0) } };
  if (box.Columns[0] >= box.Columns[1] || box.Rows[0] >= box.Rows[1] ||
    (this->Share && !this->Share->Overlaps(box.Columns, box.Rows)))
  {
    return;
  }
  const ElevationRanges::Range heights = this->Ranges.Get(level, box.Columns, box.Rows);
  box.Heights = { { heights[0], heights[1] } };
  if (box.Heights[0] > box.Heights[1] || !this->View->IsVisible(box) ||
    (this->Imagery && !this->Imagery->Covers(level, column, row)))
  {
    return;
  }
  float visibility = 0.0f;
  const double error = this->Imagery ? pixels : this->LargestError * std::min(0.5 * pixels, 1.0);
  const TerrainTile* tile = this->Find(level, column, row, error, visibility);
  this->Complete = this->Complete && tile && visibility >= 1.0f;
  if (tile)
  {
    this->Tiles.push_back({ tile, visibility });
  }
  const TerrainPlacement& placement = this->View->GetPlacement();
  const double step = std::sqrt(
    std::abs(placement.Column[0] * placement.Row[1] - placement.Column[1] * placement.Row[0]));
  const double stepPixels = this->View->ProjectLength(std::ldexp(step, level), box);
  if (level <= this->FinestLevel || stepPixels <= LargestStep)
  {
    return;
  }
  for (int i = 0; i < 4; ++i)
  {
    this->Visit(level - 1, 2 * column + i % 2, 2 * row + i / 2, 0.5 * stepPixels);
  }
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  HeightTile
 * @brief   the heights of one tile of a height lattice
 *
 * Heights are bilinear in the coarsest overview that is at least as fine as the lattice; those of
 * level 0 are the samples. Beyond the last sample heights are constant. Levels are at least 0.
 * Shading normals are computed from the ring around the cells of the tile.
 *
 * Private to the modules for terrains.
 */
#ifndef HeightTile_h
#define HeightTile_h

#include "Lattice/TerrainTile.h"

#include <vector>

namespace relevo
{
struct HeightTile : TerrainTile
{
  /// Scaled heights in the unit of the raster, row by row; NaN without data.
  std::vector<float> Heights;

  /// The height of a vertex; i and j count from the first vertex of the tile, from -1 on.
  float GetHeight(int i, int j) const { return this->Heights[(j + 1) * Stride + i + 1]; }

  Kind GetKind() const override { return Kind::Heights; }
  const void* GetValues() const override { return this->Heights.data(); }
  void Clear() override { std::vector<float>().swap(this->Heights); }
};
}

#endif

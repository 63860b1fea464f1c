// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  HeightTile
 * @brief   the heights of one tile of a height lattice
 *
 * The lattice of level m has a vertex at every 2^m-th sample of the raster in both directions, from
 * the first column and row on. Its heights are bilinear in the coarsest overview that is at least
 * as fine as the lattice; those of level 0 are the samples. Beyond the last sample heights are
 * constant. Tile (c, r) covers CellsPerTile x CellsPerTile cells of the lattice, from vertex
 * CellsPerTile * (c, r) on. It stores the vertices of these cells and one more ring around them,
 * from which shading normals are computed.
 *
 * Private to the modules for terrains.
 */
#ifndef HeightTile_h
#define HeightTile_h

#include <cstddef> // for std::size_t
#include <vector>

namespace relevo
{
struct HeightTile
{
  static constexpr int CellsPerTile = 256;
  static constexpr int Stride = CellsPerTile + 3; // vertices per row

  int Level = 0; // of the lattice, at least 0
  int Column = 0;
  int Row = 0;
  /// Scaled heights in the unit of the raster, row by row; NaN without data.
  std::vector<float> Heights;

  /// The height of a vertex; i and j count from the first vertex of the tile, from -1 on.
  float GetHeight(int i, int j) const { return this->Heights[(j + 1) * Stride + i + 1]; }

  std::size_t GetMemorySize() const
  {
    return sizeof(*this) + this->Heights.capacity() * sizeof(float);
  }
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ImageryTile
 * @brief   the colours or numbers of one tile of the lattice of a raster
 *
 * Levels below 0 are finer than the samples of the raster.
 *
 * Private to the modules for terrains.
 */
#ifndef ImageryTile_h
#define ImageryTile_h

#include "Lattice/TerrainTile.h"

#include <vector>

namespace relevo
{
struct ImageryTile : TerrainTile
{
  /// Red, green, blue and alpha, one byte each in this order, row by row. Colours are multiplied by
  /// alpha, which is 0 where imagery is missing.
  std::vector<unsigned char> Colors;

  /// Instead of colours: the values of another raster, row by row; NaN without data.
  std::vector<float> Numbers;

  /// The colour of a vertex; i and j count from the first vertex of the tile, from -1 on.
  const unsigned char* GetColor(int i, int j) const
  {
    return &this->Colors[4 * (std::size_t(j + 1) * Stride + i + 1)];
  }

  Kind GetKind() const override { return Kind::Imagery; }
  const void* GetValues() const override
  {
    return this->Numbers.empty() ? static_cast<const void*>(this->Colors.data())
                                 : static_cast<const void*>(this->Numbers.data());
  }
  void Clear() override
  {
    std::vector<unsigned char>().swap(this->Colors);
    std::vector<float>().swap(this->Numbers);
  }
};
}

#endif

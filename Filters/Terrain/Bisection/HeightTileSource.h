// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightTileSource
 * @brief   provides the tiles that are in memory, and notes which are wanted
 *
 * Private to the modules for terrains.
 */
#ifndef HeightTileSource_h
#define HeightTileSource_h

#include "Lattice/HeightTile.h"

namespace relevo
{
class HeightTileSource
{
public:
  virtual ~HeightTileSource() = default;

  /**
   * A tile, or nullptr if it is not in memory, which is then to be read. The error, in pixels, is
   * that of the picture without the tile. Sets the visibility of its details, from 0 for a tile
   * that has just been read to 1.
   */
  virtual const HeightTile* Get(
    int level, int column, int row, double error, float& visibility) = 0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  HiddenBlock
 * @brief   a block of a bisected terrain that is out of sight or that another process draws
 *
 * Private to the modules for terrains.
 */
#ifndef HiddenBlock_h
#define HiddenBlock_h

#include "Lattice/HeightTile.h"

#include <cstdint>

namespace relevo
{
struct HiddenBlock
{
  int Level; // may be negative
  std::int64_t Column;
  std::int64_t Row;
  const HeightTile* Tile; // of level max(Level, 0), contains the block
};
}

#endif

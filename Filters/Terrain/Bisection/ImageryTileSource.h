// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ImageryTileSource
 * @brief   provides the imagery tiles that are in memory, and notes which are wanted
 *
 * Private to the modules for terrains.
 */
#ifndef ImageryTileSource_h
#define ImageryTileSource_h

#include "Lattice/ImageryTile.h"

namespace relevo
{
class ImageryTileSource
{
public:
  virtual ~ImageryTileSource() = default;

  /// As HeightTileSource::Get().
  virtual const ImageryTile* GetImagery(
    int level, int column, int row, double error, float& visibility) = 0;
};
}

#endif

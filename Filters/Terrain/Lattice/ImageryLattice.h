// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ImageryLattice
 * @brief   imagery of any size, resampled to the lattices of a height raster
 *
 * Private to the modules for terrains.
 */
#ifndef ImageryLattice_h
#define ImageryLattice_h

#include "Lattice/ImageryTile.h"

#include <array>
#include <string>

namespace relevo
{
class ImageryLattice
{
public:
  virtual ~ImageryLattice() = default;

  /// Whether the tiles have numbers instead of colours.
  virtual bool HasNumbers() const { return false; }
  /// The smallest and largest number, estimated from some of them.
  virtual std::array<double, 2> GetRange() const { return { { 0.0, 1.0 } }; }
  /// The name and the unit of the numbers, or "".
  virtual std::string GetName() const { return ""; }
  virtual std::string GetUnit() const { return ""; }

  /// The finest level that shows more than the next coarser one.
  virtual int GetFinestLevel() const = 0;

  /// Whether imagery may cover a part of a tile. Without it, the tile need not be read.
  virtual bool Covers(int level, int column, int row) const = 0;

  /// Read a tile, whose level, column and row are set. Returns false and sets `error` on
  /// failure. Thread-safe.
  virtual bool Read(ImageryTile& tile, std::string& error) const = 0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightLattice
 * @brief   the heights of a raster of any size, as a terrain is drawn from them
 *
 * Private to the modules for terrains.
 */
#ifndef HeightLattice_h
#define HeightLattice_h

#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "Lattice/HeightTile.h"
#include "Raster/RasterDescription.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace relevo
{
class HeightLattice
{
public:
  virtual ~HeightLattice() = default;

  /// The size of the raster, its location and units.
  virtual const RasterDescription& Describe() const = 0;

  /// Whether the errors and ranges are bounds. Otherwise they are estimates.
  virtual bool AreErrorsKnown() const = 0;
  /// Whether bounds are being computed.
  virtual bool AreErrorsPending() const { return false; }
  virtual std::shared_ptr<const BlockErrors> GetErrors() const = 0;
  virtual std::shared_ptr<const ElevationRanges> GetRanges() const = 0;

  /// Read a tile, whose level, column and row are set. Returns false and sets `error` on
  /// failure. Thread-safe.
  virtual bool Read(HeightTile& tile, std::string& error) const = 0;

  /// Read width x height vertices from (column, row) on, row by row, as LatticeSampler::Read().
  virtual bool ReadWindow(int level, int column, int row, int width, int height, float* heights,
    std::string& error) const = 0;

  /// About the bytes of memory that the errors and ranges need, and this many threads that read
  /// tiles, besides the tiles.
  virtual std::int64_t GetMemorySize(int threads) const = 0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LatticeSampler
 * @brief   reads the heights of the height lattices of a raster pyramid
 *
 * HeightTile defines the lattices. A vertex has the same height to the bit in all windows.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef LatticeSampler_h
#define LatticeSampler_h

#include "Lattice/HeightTile.h"
#include "Pyramid/PyramidFile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <string>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT LatticeSampler
{
public:
  explicit LatticeSampler(const PyramidFile& file);

  /// The level of the pyramid that has the heights of a lattice.
  int GetPyramidLevel(int level) const;

  /**
   * Read the heights of width x height vertices of a lattice from vertex (column, row) on, row by
   * row. Vertices before the first and beyond the last sample repeat the nearest. Returns false
   * and sets `error` on failure. Thread-safe.
   */
  bool Read(int level, int column, int row, int width, int height, float* heights,
    std::string& error) const;

  /// As Read(), from samples of a window of GetPyramidLevel(level) that has all that contribute.
  void Interpolate(const SampleWindow& window, const double* samples, int level, int column,
    int row, int width, int height, float* heights) const;

  /// Read a tile; `tile` has its level, column and row.
  bool Read(HeightTile& tile, std::string& error) const;

private:
  template <typename T>
  bool ReadAs(int level, int column, int row, int width, int height, float* heights,
    std::string& error) const;
  template <typename T>
  void InterpolateAs(const SampleWindow& window, const T* samples, int level, int column, int row,
    int width, int height, float* heights) const;

  const PyramidFile& File;
};
}

#endif

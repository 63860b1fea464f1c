// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ElevationRanges
 * @brief   the lowest and highest heights of parts of a raster
 *
 * The ranges are those of tiles of 256 x 256 samples, and of 2 x 2 of these, and so on. Private to
 * the modules for terrains.
 */
#ifndef ElevationRanges_h
#define ElevationRanges_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT ElevationRanges
{
public:
  static constexpr int SamplesPerTile = 256;
  using Range = std::array<float, 2>;

  /// Ranges that are all the same, until a tile is added.
  explicit ElevationRanges(const Range& all = { { 0.0f, 0.0f } });

  /// Set the range of tiles that are not added, in rasters that have heights there.
  void SetAbsent(const Range& range) { this->Absent = range; }

  /// Set the range of a tile. Call Finish() after the last.
  void AddTile(int column, int row, const Range& range);
  void Finish();

  /**
   * The range of at least the samples of columns[0] to columns[1] and rows[0] to rows[1], and what
   * is bilinear between. Tiles of 2^level x 2^level of the smallest are looked at. For fewer
   * samples or a lower level, the range is the same or a part. The first height is the larger one
   * if there are no heights.
   */
  Range Get(
    int level, const std::array<double, 2>& columns, const std::array<double, 2>& rows) const;

private:
  using Tiles = std::unordered_map<std::uint64_t, Range>;

  Range All;
  Range Absent = { { 1.0f, 0.0f } };
  std::vector<Tiles> Levels;
};
}

#endif

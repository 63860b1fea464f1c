// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidIndex
 * @brief   what is known of the tiles of a raster pyramid without reading them
 *
 * Tiles have TileSize x TileSize samples, fewer at the right and lower border. Values are those of
 * stored samples, without scale and offset, and are rounded so that they stay bounds. A tile
 * without a record has absent samples alone; see PyramidFile::GetAbsentSample(). The errors of
 * blocks are in the unit of the heights.
 *
 * Private to the module.
 */
#ifndef PyramidIndex_h
#define PyramidIndex_h

#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT PyramidIndex
{
public:
  static constexpr int TileSize = 256;
  static constexpr char FileExtension[] = ".relevo-index"; // after the name of the raster
  static constexpr float Infinity = std::numeric_limits<float>::infinity();

  struct Record
  {
    float Minimum; // of stored samples; more than Maximum if none has data
    float Maximum;
    float Deviation; // from full resolution, at most
  };

  explicit PyramidIndex(const std::vector<std::array<int, 2>>& sizes = {});

  /// nullptr for a tile without a record.
  const Record* Find(int level, int column, int row) const;

  //@{
  /**
   * Extend the record of a tile, which is made if there is none. A deviation is that of any point
   * of the tile.
   */
  void AddRange(int level, int column, int row, double minimum, double maximum);
  void AddDeviation(int level, int column, int row, double deviation);
  //@}

  /// Note that tiles, or parts of them, have absent samples of this value. NaN has no effect.
  void AddAbsent(double sample);

  /// The largest deviation of all tiles of a level.
  double GetMaximumDeviation(int level) const;
  /// The range of the samples of a level; false if none has data.
  bool GetRange(int level, double range[2]) const;

  /// The ranges of heights = scale * sample + offset.
  ElevationRanges MakeElevationRanges(double scale, double offset) const;

  //@{
  /// The errors of blocks; nullptr if there are none.
  void SetBlockErrors(std::shared_ptr<const BlockErrors> errors) { this->Errors = errors; }
  const std::shared_ptr<const BlockErrors>& GetBlockErrors() const { return this->Errors; }
  //@}

  /// About the bytes of memory in use, including those of ranges and block errors.
  std::int64_t GetMemorySize() const;

  /// Read a file that Write() has written for a raster of this signature; false if it is not one,
  /// or has tiles outside of the raster or numbers that are NaN.
  bool Read(const std::string& fileName, const std::string& signature);
  /// Write a file, or replace it. Returns why that failed, or "".
  std::string Write(const std::string& fileName, const std::string& signature) const;

private:
  bool IsValid(std::size_t level, std::uint64_t key, const Record& record) const;

  std::vector<std::array<int, 2>> Sizes;
  std::vector<std::unordered_map<std::uint64_t, Record>> Levels;
  Record Absent{ Infinity, -Infinity, 0.0f }; // of samples that are not stored
  std::shared_ptr<const BlockErrors> Errors;
};
}

#endif

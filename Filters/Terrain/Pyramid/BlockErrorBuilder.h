// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BlockErrorBuilder
 * @brief   collects the errors of the blocks of a raster, area by area, and saturates them
 *
 * Areas of full resolution are blocks of level 7. Coarser levels are measured afterwards, on the
 * lattices of levels 7 and 14, in areas that were measured in part. Areas that are not measured
 * have absent samples on all levels, and no errors.
 *
 * Work and memory are proportional to the number of areas. The result does not depend on their
 * order.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef BlockErrorBuilder_h
#define BlockErrorBuilder_h

#include "Lattice/BlockErrors.h"
#include "Pyramid/BlockErrorArea.h"
#include "Pyramid/LatticeSampler.h"
#include "Pyramid/PyramidFile.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace relevo
{
class BlockErrorBuilder
{
public:
  explicit BlockErrorBuilder(const PyramidFile& file);

  /// The samples of an area per side.
  static constexpr int SamplesPerArea = BlockErrorArea::CellsPerArea;

  //@{
  /**
   * Measure a part of full resolution that consists of areas and one more column and row, where
   * there are any: first read its samples, as stored, into the reference of a new area. Then set
   * the samples of this window and those of the windows of coarser levels of the pyramid that cover
   * it. ScaleReference() and Add() follow. Thread-safe, for different parts.
   */
  static std::unique_ptr<BlockErrorArea> NewArea(const SampleWindow& window);
  void SetSamples(
    BlockErrorArea& area, const SampleWindow& window, const std::vector<double>& samples) const;
  void ScaleReference(BlockErrorArea& area) const;
  void Add(BlockErrorArea& area);
  //@}

  /**
   * Request the measurement of the areas around a sample of a coarser level of the pyramid, where
   * full resolution has absent samples only. Thread-safe.
   */
  void RequestAreas(int pyramidLevel, int column, int row);
  /// The windows of the requested areas of full resolution that are not measured.
  std::vector<SampleWindow> GetRequestedAreas() const;

  /// Measure the coarser levels and return the errors. Lattices that cannot be read have no data;
  /// the first such failure is set unless `error` has one.
  std::shared_ptr<const BlockErrors> Finish(const std::atomic<bool>& abort, std::string& error);

private:
  static constexpr int Step = BlockErrorArea::NumberOfLevels;
  static constexpr int VerticesPerBlock = BlockErrors::CellsPerBlock + 1;

  /// A block of the last level of an area, for the measurement of coarser levels.
  struct Block
  {
    std::array<float, VerticesPerBlock * VerticesPerBlock> Heights;
    std::array<BlockErrorArea::Range, 4> Corners;
    std::uint8_t Contents;
    float Base;
  };
  using Keys = std::unordered_set<std::uint64_t>;

  /// Errors as numbers of steps of 2^(1/8), or None for 0.
  using Tile = std::array<BlockErrors::Values<std::int16_t>, BlockErrors::NumberOfKinds>;
  using Tiles = std::unordered_map<std::uint64_t, Tile>;

  static std::int16_t Encode(float error);
  static void Raise(Tiles& tiles, int kind, int column, int row, std::int16_t code);
  void StoreSquares(int level, const std::array<int, 2>& first, const ValueGrid<float>& errors);
  void StoreFaces(
    int level, const std::array<int, 2>& first, const ValueGrid<BlockErrorArea::Sides>& errors);
  void SaturateEdges(int level, int smallest);
  void SaturateSquares(int level);
  void StoreBlocks(BlockErrorArea& area);
  void MeasureCoarser(int baseLevel, const std::atomic<bool>& abort, std::string& error);
  std::unique_ptr<BlockErrorArea> NewCoarserArea(int baseLevel, int column, int row) const;
  std::int16_t Saturate();
  std::shared_ptr<const BlockErrors> MakeErrors(std::int16_t largest) const;
  std::array<int, 2> GetNumberOfBlocks(int level) const;

  const PyramidFile& File;
  LatticeSampler Sampler;
  int RootLevel;
  double SampleDistance;
  std::mutex Mutex; // protects the next members
  std::vector<Tiles> Levels;
  std::array<std::unordered_map<std::uint64_t, Block>, 3> Blocks; // of levels 7, 14 and 21
  std::array<Keys, 3> Requests;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TileCache
 * @brief   tiles of a raster pyramid within a limit of memory; the least recently used go first
 *
 * Thread-safe. Tiles that a caller still holds do not count, and neither does the one that is read.
 *
 * Private to the module.
 */
#ifndef TileCache_h
#define TileCache_h

#include "Pyramid/PyramidTile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT TileCache
{
public:
  using TilePointer = std::shared_ptr<const PyramidTile>;

  void SetLimit(std::size_t bytes);
  void Clear();
  std::size_t GetMemorySize() const;

  /// The tile of a level in a column and row of tiles. Unless it is cached, load() makes it, and
  /// returns nullptr on failure.
  TilePointer Get(int level, int column, int row, const std::function<TilePointer()>& load);

private:
  using Entry = std::pair<std::uint64_t, TilePointer>;

  void Trim();

  mutable std::mutex Mutex;
  std::size_t Limit = std::size_t(1) << 28;
  std::size_t Size = 0;
  std::list<Entry> Entries; // the most recently used first
  std::unordered_map<std::uint64_t, std::list<Entry>::iterator> Positions;
};
}

#endif

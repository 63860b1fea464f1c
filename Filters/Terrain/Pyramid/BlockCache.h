// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BlockCache
 * @brief   decoded blocks of a raster file, which the threads that read tiles share
 *
 * Tiles overlap, so that neighbouring tiles need the same blocks of the file. Each block is decoded
 * once as long as it is cached; the least recently used go first. Threads that need the same blocks
 * at the same time divide them among themselves.
 *
 * Thread-safe. Private to the module.
 */
#ifndef BlockCache_h
#define BlockCache_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT BlockCache
{
public:
  /// Samples as the file stores them.
  struct Block
  {
    std::size_t Size = 0; // bytes
    std::unique_ptr<unsigned char[]> Bytes;

    explicit Block(std::size_t size)
      : Size(size)
      , Bytes(new unsigned char[size])
    {
    }
  };
  using BlockPointer = std::shared_ptr<const Block>;

  /// The thread-specific side of a read.
  class Reader
  {
  public:
    virtual ~Reader() = default;
    /// Prepare to load blocks, before the first one. Returns false on failure.
    virtual bool Prepare() = 0;
    /// Read a block; nullptr on failure.
    virtual BlockPointer Load(std::uint64_t key) = 0;
    /// Copy what is needed.
    virtual void Use(std::uint64_t key, const Block& block) = 0;
  };

  /// Set the maximum number of bytes, without those of the blocks that are being read or used.
  void SetLimit(std::size_t bytes);

  /**
   * Use blocks, in any order. The reader loads those that are not cached, one at a time, unless
   * another thread does. Returns false as soon as that has failed.
   */
  bool Use(std::vector<std::uint64_t> keys, Reader& reader);

private:
  using Entry = std::pair<std::uint64_t, BlockPointer>;
  class Reading;

  BlockPointer Find(std::uint64_t key);
  void Add(std::uint64_t key, const BlockPointer& block);
  void Trim();

  std::mutex Mutex; // protects all members
  std::condition_variable Changed;
  std::size_t Limit = 0;
  std::size_t Size = 0;
  std::list<Entry> Entries; // the most recently used first
  std::unordered_map<std::uint64_t, std::list<Entry>::iterator> Positions;
  std::set<std::uint64_t> Running; // blocks that are being read
};
}

#endif

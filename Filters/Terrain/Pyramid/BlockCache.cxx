// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/BlockCache.h"

#include <algorithm>

namespace relevo
{
// A block that a thread reads while others wait for it or read other blocks. The mutex is locked
// before and after.
class BlockCache::Reading
{
public:
  Reading(BlockCache& cache, std::unique_lock<std::mutex>& lock, std::uint64_t key)
    : Cache(cache)
    , Lock(lock)
    , Key(key)
  {
    cache.Running.insert(key);
    lock.unlock();
  }
  ~Reading()
  {
    this->Lock.lock();
    this->Cache.Running.erase(this->Key);
    this->Cache.Changed.notify_all();
  }
  Reading(const Reading&) = delete;
  void operator=(const Reading&) = delete;

private:
  BlockCache& Cache;
  std::unique_lock<std::mutex>& Lock;
  std::uint64_t Key;
};

void BlockCache::SetLimit(std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Limit = bytes;
  this->Trim();
}

bool BlockCache::Use(std::vector<std::uint64_t> keys, Reader& reader)
{
  bool isPrepared = false;
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!keys.empty())
  {
    BlockPointer block;
    auto next = std::find_if(keys.begin(), keys.end(),
      [this, &block](std::uint64_t key)
      {
        block = this->Find(key);
        return block != nullptr;
      });
    if (!block)
    {
      next = std::find_if(keys.begin(), keys.end(),
        [this](std::uint64_t key) { return this->Running.count(key) == 0; });
      if (next == keys.end())
      {
        this->Changed.wait(lock);
        continue;
      }
      if (!isPrepared)
      {
        // Others read these blocks if this takes long.
        lock.unlock();
        isPrepared = reader.Prepare();
        lock.lock();
        if (!isPrepared)
        {
          return false;
        }
        continue;
      }
      {
        const Reading reading(*this, lock, *next);
        block = reader.Load(*next);
      }
      if (!block)
      {
        return false;
      }
      this->Add(*next, block);
    }
    lock.unlock();
    reader.Use(*next, *block);
    block.reset();
    lock.lock();
    keys.erase(next);
  }
  return true;
}

BlockCache::BlockPointer BlockCache::Find(std::uint64_t key)
{
  const auto found = this->Positions.find(key);
  if (found == this->Positions.end())
  {
    return nullptr;
  }
  this->Entries.splice(this->Entries.begin(), this->Entries, found->second);
  return found->second->second;
}

void BlockCache::Add(std::uint64_t key, const BlockPointer& block)
{
  this->Entries.emplace_front(key, block);
  this->Positions[key] = this->Entries.begin();
  this->Size += block->Size;
  this->Trim();
}

void BlockCache::Trim()
{
  while (this->Size > this->Limit && !this->Entries.empty())
  {
    this->Size -= this->Entries.back().second->Size;
    this->Positions.erase(this->Entries.back().first);
    this->Entries.pop_back();
  }
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/TileCache.h"

namespace relevo
{
namespace
{
// Columns and rows of tiles are below 2^28, as samples are counted by int.
std::uint64_t MakeKey(int level, int column, int row)
{
  return (static_cast<std::uint64_t>(level) << 56) | (static_cast<std::uint64_t>(row) << 28) |
    static_cast<std::uint64_t>(column);
}
}

void TileCache::SetLimit(std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Limit = bytes;
  this->Trim();
}

void TileCache::Clear()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Entries.clear();
  this->Positions.clear();
  this->Size = 0;
}

std::size_t TileCache::GetMemorySize() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Size;
}

TileCache::TilePointer TileCache::Get(
  int level, int column, int row, const std::function<TilePointer()>& load)
{
  const std::uint64_t key = MakeKey(level, column, row);
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Positions.find(key);
    if (found != this->Positions.end())
    {
      this->Entries.splice(this->Entries.begin(), this->Entries, found->second);
      return found->second->second;
    }
  }
  TilePointer tile = load(); // others may read meanwhile
  if (tile)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Positions.count(key) == 0)
    {
      this->Entries.emplace_front(key, tile);
      this->Positions[key] = this->Entries.begin();
      this->Size += tile->GetMemorySize();
      this->Trim();
    }
  }
  return tile;
}

void TileCache::Trim()
{
  while (this->Size > this->Limit && !this->Entries.empty())
  {
    this->Size -= this->Entries.back().second->GetMemorySize();
    this->Positions.erase(this->Entries.back().first);
    this->Entries.pop_back();
  }
}
}

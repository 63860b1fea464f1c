// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests the cache of blocks that threads share: which blocks are loaded and how often, the limit of
// memory, threads that need the same blocks, and blocks that cannot be loaded.
#include "RelevoCheck.h"

#include "Pyramid/BlockCache.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{
using relevo::BlockCache;
using Keys = std::vector<std::uint64_t>;

constexpr std::size_t BlockSize = 100;

// Loads blocks of one value, and counts what the cache asks for.
class TestReader : public BlockCache::Reader
{
public:
  bool Prepare() override
  {
    ++this->NumberOfPreparations;
    return this->CanPrepare;
  }

  BlockCache::BlockPointer Load(std::uint64_t key) override
  {
    this->Loaded.push_back(key);
    if (this->Delay.count() > 0)
    {
      std::this_thread::sleep_for(this->Delay);
    }
    if (key == this->Thrown)
    {
      throw std::runtime_error("thrown");
    }
    if (key == this->Unreadable)
    {
      return nullptr;
    }
    auto block = std::make_shared<BlockCache::Block>(BlockSize);
    std::fill_n(block->Bytes.get(), BlockSize, static_cast<unsigned char>(key));
    return block;
  }

  void Use(std::uint64_t key, const BlockCache::Block& block) override
  {
    const bool isRight = block.Size == BlockSize &&
      std::all_of(block.Bytes.get(), block.Bytes.get() + BlockSize,
        [key](unsigned char byte) { return byte == static_cast<unsigned char>(key); });
    this->NumberOfDefects += isRight ? 0 : 1;
    this->Used.push_back(key);
  }

  Keys TakeLoaded()
  {
    Keys loaded;
    loaded.swap(this->Loaded);
    return loaded;
  }

  bool CanPrepare = true;
  std::chrono::milliseconds Delay{ 0 };
  std::uint64_t Thrown = ~std::uint64_t(0);
  std::uint64_t Unreadable = ~std::uint64_t(0);
  int NumberOfPreparations = 0;
  int NumberOfDefects = 0;
  Keys Loaded;
  Keys Used;
};

void TestLimit(RelevoCheck& check)
{
  BlockCache cache;
  cache.SetLimit(4 * BlockSize);
  TestReader reader;
  CHECK(cache.Use({ 1, 2, 3, 4 }, reader));
  CHECK(reader.TakeLoaded() == Keys({ 1, 2, 3, 4 }));
  CHECK_EQUAL(reader.NumberOfPreparations, 1);
  // Cached blocks need no preparation.
  CHECK(cache.Use({ 2, 1, 3, 4 }, reader));
  CHECK(reader.TakeLoaded().empty());
  CHECK_EQUAL(reader.NumberOfPreparations, 1);
  // The least recently used one goes.
  CHECK(cache.Use({ 5 }, reader));
  CHECK(cache.Use({ 1, 3, 4, 5 }, reader));
  CHECK(reader.TakeLoaded() == Keys({ 5 }));
  CHECK(cache.Use({ 2 }, reader));
  CHECK(reader.TakeLoaded() == Keys({ 2 }));
  // More blocks than the limit allows.
  CHECK(cache.Use({ 11, 12, 13, 14, 15, 16 }, reader));
  CHECK(reader.TakeLoaded() == Keys({ 11, 12, 13, 14, 15, 16 }));
  cache.SetLimit(BlockSize);
  CHECK(cache.Use({ 16, 15 }, reader));
  CHECK(reader.TakeLoaded() == Keys({ 15 }));
  cache.SetLimit(0);
  CHECK(cache.Use({ 15 }, reader));
  CHECK(reader.TakeLoaded() == Keys({ 15 }));
  CHECK_EQUAL(reader.Used.size(), 4u + 4 + 1 + 4 + 1 + 6 + 2 + 1);
  CHECK_EQUAL(reader.NumberOfDefects, 0);
}

void TestFailures(RelevoCheck& check)
{
  BlockCache cache;
  cache.SetLimit(10 * BlockSize);
  TestReader reader;
  reader.CanPrepare = false;
  CHECK(!cache.Use({ 1 }, reader));
  CHECK(reader.Loaded.empty());
  reader.CanPrepare = true;
  reader.Unreadable = 2;
  CHECK(!cache.Use({ 1, 2, 3 }, reader));
  reader.Thrown = 3;
  bool isThrown = false;
  try
  {
    cache.Use({ 1, 3 }, reader);
  }
  catch (const std::runtime_error&)
  {
    isThrown = true;
  }
  CHECK(isThrown);
  CHECK(reader.TakeLoaded() == Keys({ 1, 2, 3 }));
  // Another reader may be able to load them.
  TestReader other;
  CHECK(cache.Use({ 1, 2, 3 }, other));
  CHECK(other.TakeLoaded() == Keys({ 2, 3 }));
}

// Threads divide the blocks that all of them need, and each block is loaded once.
void TestThreads(RelevoCheck& check)
{
  constexpr int numberOfThreads = 4;
  constexpr std::uint64_t numberOfBlocks = 60;
  BlockCache cache;
  cache.SetLimit(numberOfBlocks * BlockSize);
  std::vector<TestReader> readers(numberOfThreads);
  std::vector<std::thread> threads;
  std::atomic<int> failures{ 0 };
  for (TestReader& reader : readers)
  {
    reader.Delay = std::chrono::milliseconds(2);
    threads.emplace_back(
      [&cache, &reader, &failures]
      {
        Keys keys;
        for (std::uint64_t key = 0; key < numberOfBlocks; ++key)
        {
          keys.push_back(key);
        }
        failures += cache.Use(keys, reader) ? 0 : 1;
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  CHECK_EQUAL(failures, 0);
  Keys loaded;
  for (const TestReader& reader : readers)
  {
    CHECK_EQUAL(reader.Used.size(), numberOfBlocks);
    CHECK_EQUAL(reader.NumberOfDefects, 0);
    loaded.insert(loaded.end(), reader.Loaded.begin(), reader.Loaded.end());
  }
  std::sort(loaded.begin(), loaded.end());
  CHECK_EQUAL(loaded.size(), numberOfBlocks);
  CHECK(std::adjacent_find(loaded.begin(), loaded.end()) == loaded.end());
}

// A reader that waits loads the block itself if the other one fails.
class FailingReader : public TestReader
{
public:
  BlockCache::BlockPointer Load(std::uint64_t) override
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->IsLoading = true;
    this->Changed.notify_all();
    this->Changed.wait_for(lock, std::chrono::milliseconds(50)); // until the other one waits
    return nullptr;
  }

  void WaitForLoading()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->IsLoading; });
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  bool IsLoading = false;
};

void TestWaitingForFailure(RelevoCheck& check)
{
  BlockCache cache;
  cache.SetLimit(BlockSize);
  FailingReader failing;
  bool isUsed = true;
  std::thread thread([&] { isUsed = cache.Use({ 7 }, failing); });
  failing.WaitForLoading();
  TestReader reader;
  CHECK(cache.Use({ 7 }, reader));
  CHECK(reader.Loaded == Keys({ 7 }));
  CHECK_EQUAL(reader.NumberOfPreparations, 1);
  thread.join();
  CHECK(!isUsed);
}
}

int TestBlockCache(int, char*[])
{
  RelevoCheck check;
  TestLimit(check);
  TestFailures(check);
  TestThreads(check);
  TestWaitingForFailure(check);
  return check.GetResult();
}

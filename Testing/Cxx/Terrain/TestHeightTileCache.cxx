// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests the paging of tiles of heights and imagery with tiles that are made in memory: the limit of
// memory, the order of reading, which tiles are replaced, and reads that fail, hang or are no
// longer wanted.
#include "RelevoCheck.h"
#include "RelevoDice.h"

#include "Bisection/HeightTileCache.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using relevo::HeightTile;
using relevo::HeightTileCache;
using relevo::ImageryTile;
using relevo::TerrainTile;

namespace
{
using Position = std::array<int, 3>; // level, column, row

constexpr int RootLevel = 5;
constexpr double Infinite = std::numeric_limits<double>::infinity();

// Makes tiles. A closed store completes a read only for each Permit().
class TileStore
{
public:
  bool Read(HeightTile& tile, std::string& error)
  {
    const Position position = { { tile.Level, tile.Column, tile.Row } };
    ++this->NumberOfReading;
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Started.push_back(position);
    this->Changed.notify_all();
    this->Changed.wait(lock, [this] { return this->IsOpen || this->Permits > 0; });
    this->Permits -= this->IsOpen ? 0 : 1;
    const bool isBad = this->Bad.count(position) > 0;
    const int badKind = tile.Column;
    lock.unlock();
    tile.Heights.resize(std::size_t(HeightTile::Stride) * HeightTile::Stride,
      static_cast<float>(100 * tile.Level + 10 * tile.Column + tile.Row));
    this->CheckMemory();
    --this->NumberOfReading;
    if (isBad && badKind == 1)
    {
      throw std::bad_alloc();
    }
    if (isBad && badKind == 2)
    {
      throw std::runtime_error("thrown");
    }
    if (isBad && badKind == 3)
    {
      throw 3;
    }
    error = isBad ? "bad tile" : "";
    return !isBad;
  }

  void Open()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsOpen = true;
    this->Changed.notify_all();
  }
  void Close()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsOpen = false;
  }
  void Permit()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Permits;
    this->Changed.notify_all();
  }
  void SetBad(const std::vector<Position>& tiles)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Bad = std::set<Position>(tiles.begin(), tiles.end());
  }

  std::vector<Position> GetStarted() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Started;
  }
  // Waits until this many reads have started since the store was made.
  void WaitForStarted(std::size_t number)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this, number] { return this->Started.size() >= number; });
  }

  void CheckMemory()
  {
    const HeightTileCache* cache = this->Cache;
    if (cache && cache->GetMemorySize() > this->Limit)
    {
      this->IsExceeded = true;
    }
  }

  std::atomic<const HeightTileCache*> Cache{ nullptr };
  std::atomic<std::size_t> Limit{ 0 };
  std::atomic<bool> IsExceeded{ false };
  std::atomic<int> NumberOfReading{ 0 };

private:
  mutable std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<Position> Started;
  std::set<Position> Bad;
  bool IsOpen = true;
  int Permits = 0;
};

HeightTileCache::ImageryReader ReadImageryFrom(TileStore& store)
{
  return [&store](ImageryTile& tile, std::string& error)
  {
    HeightTile heights;
    heights.Level = tile.Level;
    heights.Column = tile.Column;
    heights.Row = tile.Row;
    tile.Colors.assign(4 * TerrainTile::NumberOfVertices, static_cast<unsigned char>(tile.Column));
    return store.Read(heights, error);
  };
}

HeightTileCache::Reader ReadFrom(TileStore& store)
{
  return [&store](HeightTile& tile, std::string& error) { return store.Read(tile, error); };
}

struct Want
{
  Position Tile;
  double Error;
};

std::vector<Want> WithRoot(const std::vector<Want>& wants)
{
  std::vector<Want> all = { { { { RootLevel, 0, 0 } }, Infinite },
    { { { RootLevel - 1, 0, 0 } }, Infinite } };
  all.insert(all.end(), wants.begin(), wants.end());
  return all;
}

// One frame; returns the visibilities, -1 for missing tiles.
std::vector<float> RunFrame(
  HeightTileCache& cache, const std::vector<Want>& wants, double now = 0.0)
{
  cache.BeginFrame(now);
  std::vector<float> visibilities;
  for (const Want& want : wants)
  {
    const Position& p = want.Tile;
    float visibility = -2.0f;
    const HeightTile* tile = cache.Get(p[0], p[1], p[2], want.Error, visibility);
    const bool isRight = !tile ||
      (tile->Level == p[0] && tile->Column == p[1] && tile->Row == p[2] &&
        tile->GetHeight(-1, 257) == static_cast<float>(100 * p[0] + 10 * p[1] + p[2]));
    visibilities.push_back(!isRight ? -2.0f : tile ? visibility : -1.0f);
  }
  cache.EndFrame();
  return visibilities;
}

// Runs frames until all tiles that fit are in memory.
std::vector<float> RunFrames(HeightTileCache& cache, const std::vector<Want>& wants)
{
  std::vector<float> visibilities = RunFrame(cache, wants);
  while (cache.LoadWanted())
  {
    visibilities = RunFrame(cache, wants);
  }
  return visibilities;
}

void WaitUntilIdle(const HeightTileCache& cache)
{
  while (cache.IsLoading())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::size_t GetNumberOfWorkers()
{
  return std::clamp(std::thread::hardware_concurrency(), 1u, 4u);
}

std::size_t SizeOf(int tiles)
{
  return tiles * HeightTileCache::BytesPerTile;
}

using Visibilities = std::vector<float>;

void TestLimit(RelevoCheck& check, std::size_t limit)
{
  CHECK_CASE(limit);
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  store.Limit = limit;
  store.Cache = &cache;
  cache.SetMemoryLimit(limit);
  RelevoDice dice(7);
  const int capacity = static_cast<int>(limit / HeightTileCache::BytesPerTile);
  int mostTiles = 0;
  for (int frame = 0; frame < 200; ++frame)
  {
    std::vector<Want> wants;
    for (int i = 0; i < 100; ++i)
    {
      wants.push_back(
        { { { dice.Throw(RootLevel - 1), dice.Throw(8), dice.Throw(8) } }, 10.0 * dice.Share() });
    }
    RunFrame(cache, WithRoot(wants), 0.01 * frame);
    CHECK(cache.GetNumberOfTiles() + store.NumberOfReading <= capacity);
    CHECK(cache.GetMemorySize() <= limit);
    if (dice.Once(10))
    {
      cache.LoadWanted();
    }
    mostTiles = std::max(mostTiles, cache.GetNumberOfTiles());
    if (dice.Once(4))
    {
      WaitUntilIdle(cache);
    }
  }
  CHECK(!store.IsExceeded);
  CHECK_EQUAL(mostTiles, capacity);
  CHECK_EQUAL(store.GetStarted().empty(), capacity == 0);

  // A smaller limit holds from the next frame on. The coarsest tiles stay longest.
  WaitUntilIdle(cache);
  cache.SetMemoryLimit(limit / 2);
  cache.BeginFrame(3.0);
  CHECK(cache.GetMemorySize() <= limit / 2);
  float visibility = 0.0f;
  CHECK_EQUAL(cache.Get(RootLevel, 0, 0, Infinite, visibility) != nullptr, capacity / 2 > 0);
  cache.EndFrame();
}

// Heights and imagery take turns by their errors, and together stay within the limit.
void TestImageryLimit(RelevoCheck& check, std::size_t limit)
{
  CHECK_CASE(limit);
  TileStore store;
  HeightTileCache cache(ReadFrom(store), ReadImageryFrom(store));
  store.Limit = limit;
  store.Cache = &cache;
  cache.SetMemoryLimit(limit);
  RelevoDice dice(11);
  const int capacity = static_cast<int>(limit / HeightTileCache::BytesPerTile);
  int mostHeights = 0;
  int mostImagery = 0;
  for (int frame = 0; frame < 200; ++frame)
  {
    cache.BeginFrame(0.01 * frame);
    float visibility = 0.0f;
    int heights = 0;
    int imagery = 0;
    for (int level = RootLevel - 1; level <= RootLevel; ++level)
    {
      heights += cache.Get(level, 0, 0, Infinite, visibility) ? 1 : 0;
    }
    imagery += cache.GetImagery(RootLevel, 0, 0, Infinite, visibility) ? 1 : 0;
    // All are in memory once they have been read.
    CHECK(frame < 100 || (heights == 2 && imagery == 1));
    std::set<Position> wanted;
    for (int i = 0; i < 100; ++i)
    {
      const bool isImagery = dice.Once(2);
      const Position p = { { dice.Throw(RootLevel - 1) - (isImagery ? 4 : 0), dice.Throw(8),
        dice.Throw(8) } };
      const double error = 10.0 * dice.Share();
      if (isImagery)
      {
        const ImageryTile* tile = cache.GetImagery(p[0], p[1], p[2], error, visibility);
        imagery += tile && wanted.insert(p).second ? 1 : 0;
        CHECK(!tile || (tile->Level == p[0] && tile->GetColor(257, -1)[3] == p[1]));
      }
      else
      {
        const HeightTile* tile = cache.Get(p[0], p[1], p[2], error, visibility);
        heights += tile && wanted.insert(Position{ { p[0] + 100, p[1], p[2] } }).second ? 1 : 0;
        CHECK(!tile || (tile->Level == p[0] && tile->Column == p[1]));
      }
    }
    CHECK_LESS_EQUAL(heights + imagery, capacity);
    cache.EndFrame();
    CHECK(cache.GetNumberOfTiles() + store.NumberOfReading <= capacity);
    CHECK(cache.GetMemorySize() <= limit);
    mostHeights = std::max(mostHeights, heights);
    mostImagery = std::max(mostImagery, imagery);
    if (dice.Once(4) || frame == 99)
    {
      WaitUntilIdle(cache);
    }
  }
  CHECK(!store.IsExceeded);
  CHECK_GREATER(mostHeights, capacity / 6);
  CHECK_GREATER(mostImagery, capacity / 6);
}

// The larger error replaces the smaller one, of either kind.
void TestImageryReplacement(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store), ReadImageryFrom(store));
  cache.SetMemoryLimit(SizeOf(4));
  cache.SetFadeTime(0.0);
  float visibility = 0.0f;
  const auto draw = [&](double heightError, double imageryError)
  {
    std::array<bool, 2> found{};
    for (bool hasMore = true; hasMore; hasMore = cache.LoadWanted())
    {
      cache.BeginFrame(0.0);
      cache.Get(RootLevel, 0, 0, Infinite, visibility);
      cache.Get(RootLevel - 1, 0, 0, Infinite, visibility);
      cache.GetImagery(RootLevel, 0, 0, Infinite, visibility);
      found = { { cache.Get(2, 3, 1, heightError, visibility) != nullptr,
        cache.GetImagery(2, 3, 1, imageryError, visibility) != nullptr } };
      cache.EndFrame();
    }
    return found;
  };
  CHECK(draw(2.0, 1.0) == (std::array<bool, 2>{ { true, false } }));
  CHECK(draw(2.0, 2.4) == (std::array<bool, 2>{ { true, false } }));
  CHECK(draw(2.0, 2.6) == (std::array<bool, 2>{ { false, true } }));
  CHECK(draw(4.0, 2.6) == (std::array<bool, 2>{ { true, false } }));
  CHECK_EQUAL(cache.GetMemorySize(), SizeOf(4));
  // Errors are reported for each kind.
  store.SetBad({ { { 1, 0, 0 } } });
  cache.SetMemoryLimit(SizeOf(8));
  cache.BeginFrame(0.0);
  cache.GetImagery(1, 0, 0, 1.0, visibility);
  cache.EndFrame();
  cache.LoadWanted();
  CHECK_EQUAL(cache.TakeError(TerrainTile::Kind::Heights), "");
  CHECK_EQUAL(cache.TakeError(TerrainTile::Kind::Imagery), "bad tile");
  CHECK_EQUAL(cache.TakeError(TerrainTile::Kind::Imagery), "");
}

// The order is that of the powers of 2 of the largest errors of a frame. Reads that have not begun
// are cancelled.
void TestOrder(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  RunFrames(cache, WithRoot({}));
  store.Close();
  const std::size_t workers = GetNumberOfWorkers();
  const std::size_t before = store.GetStarted().size();
  std::vector<Want> wants;
  for (int column = 10; column < 22; ++column)
  {
    wants.push_back({ { { 2, column, 0 } }, 1.0 + (7 * column) % 12 });
  }
  wants.push_back({ { { 2, 3, 0 } }, 0.2 });
  wants.push_back({ { { 2, 3, 0 } }, 50.0 });
  wants.push_back({ { { 2, 3, 0 } }, 0.5 });
  RunFrame(cache, WithRoot(wants));
  std::stable_sort(wants.begin(), wants.end(),
    [](const Want& a, const Want& b)
    {
      return std::make_pair(std::logb(b.Error), a.Tile) <
        std::make_pair(std::logb(a.Error), b.Tile);
    });
  for (std::size_t i = 0; i < 4; ++i)
  {
    store.WaitForStarted(before + workers + i);
    store.Permit();
  }
  store.WaitForStarted(before + workers + 4);
  const std::vector<Position> started = store.GetStarted();
  CHECK_EQUAL(started.size(), before + workers + 4);
  // The first reads begin at the same time.
  std::set<Position> first(started.begin() + before, started.begin() + before + workers);
  for (std::size_t i = 0; i < workers + 4; ++i)
  {
    if (i < workers)
    {
      CHECK_EQUAL(first.count(wants[i].Tile), 1);
    }
    else
    {
      CHECK(started[before + i] == wants[i].Tile);
    }
  }

  // The reads in progress are completed, and no others begin.
  RunFrame(cache, WithRoot({}));
  CHECK(cache.IsLoading());
  store.Open();
  WaitUntilIdle(cache);
  CHECK_EQUAL(store.GetStarted().size(), before + workers + 4);
  CHECK(cache.NeedsFrame());
  RunFrame(cache, WithRoot({}));
  CHECK(!cache.NeedsFrame());
  CHECK_EQUAL(cache.GetNumberOfTiles(), before + workers + 4);
}

// Tiles with similar errors are read along a Z-order curve, the coarser ones first.
void TestNeighbors(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  cache.SetNumberOfReads(1);
  RunFrames(cache, WithRoot({}));
  const std::size_t before = store.GetStarted().size();
  RelevoDice dice(3);
  std::vector<Want> wants;
  for (int i = 0; i < 256; ++i)
  {
    wants.push_back({ { { 1, i % 16, i / 16 } }, 4.0 + 3.9 * dice.Share() });
    wants.push_back({ { { 2, i % 16, i / 16 } }, 4.0 + 3.9 * dice.Share() });
  }
  RunFrames(cache, WithRoot(wants));
  const std::vector<Position> started = store.GetStarted();
  if (!CHECK_EQUAL(started.size(), before + wants.size()))
  {
    return;
  }
  for (int i = 0; i < 512; ++i)
  {
    Position expected = { { i < 256 ? 2 : 1, 0, 0 } };
    for (int bit = 0; bit < 4; ++bit)
    {
      expected[1] |= (i >> (2 * bit) & 1) << bit;
      expected[2] |= (i >> (2 * bit + 1) & 1) << bit;
    }
    CHECK(started[before + i] == expected);
  }
}

void TestReplacement(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  cache.SetMemoryLimit(SizeOf(5));
  cache.SetFadeTime(0.0);
  const Position a = { { 1, 0, 0 } };
  const Position b = { { 1, 1, 0 } };
  const Position c = { { 1, 2, 0 } };
  const Position d = { { 1, 3, 0 } };
  const Position e = { { 1, 4, 0 } };
  RunFrames(cache, WithRoot({ { a, 9.0 }, { b, 1.0 }, { c, 2.0 } }));
  RunFrame(cache, WithRoot({ { c, 2.0 }, { b, 1.0 } }));
  RunFrame(cache, WithRoot({ { b, 1.0 } }));
  // Tile a is the least recently wanted one. Unwanted tiles go even for smaller errors.
  CHECK(RunFrames(cache, WithRoot({ { d, 0.5 } })) == Visibilities({ 1, 1, 1 }));
  CHECK(RunFrame(cache, WithRoot({ { a, 0.0 }, { b, 1.0 }, { c, 2.0 }, { d, 0.5 } })) ==
    Visibilities({ 1, 1, -1, 1, 1, 1 }));

  // Of the wanted ones, that with the smallest error goes, unless the difference is small. The
  // coarsest tiles never go.
  const std::vector<Want> similar = WithRoot({ { b, 1.0 }, { c, 2.0 }, { d, 0.9 }, { e, 1.1 } });
  const std::size_t before = store.GetStarted().size();
  for (int i = 0; i < 10; ++i)
  {
    CHECK(RunFrames(cache, similar) == Visibilities({ 1, 1, 1, 1, 1, -1 }));
  }
  CHECK_EQUAL(store.GetStarted().size(), before);
  CHECK(!cache.IsLoading() && !cache.NeedsFrame());
  const std::vector<Want> wants = WithRoot({ { b, 1.0 }, { c, 2.0 }, { d, 0.9 }, { e, 1.2 } });
  CHECK(RunFrames(cache, wants) == Visibilities({ 1, 1, 1, 1, -1, 1 }));
  CHECK_EQUAL(store.GetStarted().size(), before + 1);

  // Not even if a frame does not want them.
  std::vector<Want> others;
  for (int column = 5; column < 9; ++column)
  {
    others.push_back({ { { 1, column, 0 } }, 9.0 });
  }
  CHECK(RunFrames(cache, others) == Visibilities({ -1, 1, 1, 1 }));
  CHECK(RunFrames(cache, wants) == Visibilities({ 1, 1, 1, 1, -1, 1 }));

  // A frame keeps its tiles to its end, and the next one drops them.
  const std::vector<Want> last =
    WithRoot({ { a, 30.0 }, { d, 20.0 }, { b, 4.0 }, { c, 4.0 }, { e, 4.0 } });
  store.Close();
  const std::size_t started = store.GetStarted().size();
  cache.BeginFrame(1.0);
  std::vector<const HeightTile*> tiles;
  float visibility = 0.0f;
  for (const Want& want : last)
  {
    tiles.push_back(cache.Get(want.Tile[0], want.Tile[1], want.Tile[2], want.Error, visibility));
  }
  cache.EndFrame();
  CHECK_EQUAL(cache.GetNumberOfTiles(), 5);
  CHECK_EQUAL(tiles[4]->GetHeight(0, 0), 110.0f);
  CHECK(cache.NeedsFrame() && !cache.IsLoading());
  CHECK_EQUAL(store.GetStarted().size(), started);
  cache.BeginFrame(2.0);
  CHECK_EQUAL(cache.GetNumberOfTiles(), 3);
  store.WaitForStarted(started + 1);
  CHECK_EQUAL(cache.Get(RootLevel, 0, 0, Infinite, visibility), tiles[0]);
  store.Open();
  cache.EndFrame();
}

// Frames go on while a read hangs.
void TestHangingRead(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  RunFrames(cache, WithRoot({}));
  store.Close();
  for (int i = 0; i < 100; ++i)
  {
    const std::vector<Want> wants = WithRoot({ { { { 2, i / 30, 0 } }, 1.0 } });
    CHECK(RunFrame(cache, wants, i) == Visibilities({ 1, 1, -1 }));
    CHECK(cache.IsLoading() && !cache.NeedsFrame());
    CHECK(cache.GetMemorySize() <= SizeOf(6));
  }
  // A caller that waits can give up.
  int calls = 0;
  CHECK(!cache.LoadWanted([&calls] { return ++calls == 3; }));
  CHECK_EQUAL(calls, 3);
  store.Open();
}

void TestErrors(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  const std::vector<Position> bad = { { { 2, 0, 0 } }, { { 2, 1, 0 } }, { { 2, 2, 0 } },
    { { 2, 3, 0 } } };
  const std::vector<std::string> errors = { "bad tile",
    "there is not enough memory to read a tile of heights", "thrown",
    "a tile of heights cannot be read" };
  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    CHECK_CASE(i);
    store.SetBad({ bad[i] });
    cache.Clear();
    CHECK_EQUAL(cache.GetMemorySize(), 0);
    const std::size_t before = store.GetStarted().size();
    const std::vector<Want> wants = WithRoot({ { bad[i], 5.0 }, { { { 1, 0, 0 } }, 4.0 } });
    for (int repetition = 0; repetition < 3; ++repetition)
    {
      CHECK(RunFrames(cache, wants) == Visibilities({ 1, 1, -1, 1 }));
      CHECK_EQUAL(cache.TakeError(), repetition == 0 ? errors[i] : std::string());
    }
    CHECK_EQUAL(store.GetStarted().size(), before + 4);
    CHECK_EQUAL(cache.GetMemorySize(), SizeOf(3));
    CHECK(!cache.IsLoading());
  }
  // An unreadable tile does not take the room of others.
  store.SetBad(bad);
  cache.Clear();
  cache.SetMemoryLimit(SizeOf(3));
  CHECK(RunFrames(cache,
          WithRoot({ { bad[0], 9.0 }, { bad[1], 8.0 }, { bad[2], 7.0 },
            { { { 1, 0, 0 } }, 1.0 } })) == Visibilities({ 1, 1, -1, -1, -1, 1 }));
  CHECK_EQUAL(cache.TakeError(), errors[0]);
  CHECK_EQUAL(cache.TakeError(), "");
}

// A tile that cannot be read is requested again after 10 seconds, then after 20.
void TestRetry(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  cache.SetFadeTime(0.0);
  const std::vector<Want> wants = WithRoot({ { { { 2, 0, 0 } }, 5.0 } });
  store.SetBad({ wants.back().Tile });
  double now = 100.0;
  const auto draw = [&]
  {
    RunFrame(cache, wants, now);
    WaitUntilIdle(cache);
    return RunFrame(cache, wants, now).back();
  };
  CHECK_EQUAL(draw(), -1.0f);
  CHECK_EQUAL(store.GetStarted().size(), 3);
  CHECK_EQUAL(cache.TakeError(), "bad tile");
  now += 9.9;
  CHECK_EQUAL(draw(), -1.0f);
  CHECK_EQUAL(store.GetStarted().size(), 3);
  now += 0.2;
  CHECK_EQUAL(draw(), -1.0f);
  CHECK_EQUAL(store.GetStarted().size(), 4);
  store.SetBad({});
  now += 19.9;
  CHECK_EQUAL(draw(), -1.0f);
  now += 0.2;
  CHECK_EQUAL(draw(), 1.0f);
  CHECK_EQUAL(store.GetStarted().size(), 5);
  CHECK_EQUAL(cache.TakeError(), ""); // one error
}

// Few reads at the same time need little memory.
void TestNumberOfReads(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  cache.SetNumberOfReads(1);
  RunFrames(cache, WithRoot({}));
  store.Close();
  RunFrame(cache, WithRoot({ { { { 2, 0, 0 } }, 5.0 }, { { { 2, 1, 0 } }, 4.0 } }));
  for (std::size_t i = 0; i < 2; ++i)
  {
    store.WaitForStarted(3 + i);
    CHECK_EQUAL(store.NumberOfReading, 1);
    store.Permit();
  }
  WaitUntilIdle(cache);
}

// The end does not wait for a read that hangs. The thread ends after the cache.
void TestHangingEnd(RelevoCheck& check)
{
  const auto store = std::make_shared<TileStore>();
  store->Close();
  {
    HeightTileCache cache(
      [store](HeightTile& tile, std::string& error) { return store->Read(tile, error); });
    RunFrame(cache, WithRoot({}));
    store->WaitForStarted(1);
  }
  CHECK_GREATER(store->NumberOfReading, 0);
  store->Open();
  while (store.use_count() > 1) // the thread has it
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK_EQUAL(store->NumberOfReading, 0);
}

void TestFade(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  cache.SetFadeTime(0.5);
  const std::vector<Want> wants = WithRoot({ { { { 2, 0, 0 } }, 5.0 } });
  RunFrame(cache, wants, 10.0);
  WaitUntilIdle(cache);
  // The coarsest tiles are visible at once. Others begin with the first frame that uses them.
  CHECK(RunFrame(cache, WithRoot({}), 20.0) == Visibilities({ 1, 1 }));
  CHECK(!cache.NeedsFrame());
  CHECK(RunFrame(cache, wants, 30.0) == Visibilities({ 1, 1, 0 }));
  CHECK(cache.NeedsFrame());
  float last = 0.0f;
  for (int i = 1; i < 8; ++i)
  {
    const float visibility = RunFrame(cache, wants, 30.0 + 0.0625 * i)[2];
    CHECK(visibility > last && visibility < 1.0f);
    CHECK_NEAR(visibility, 0.125 * i, 1e-6);
    last = visibility;
  }
  CHECK(RunFrame(cache, wants, 30.5) == Visibilities({ 1, 1, 1 }));
  CHECK(!cache.NeedsFrame());
  CHECK(RunFrame(cache, wants, 40.0) == Visibilities({ 1, 1, 1 }));

  cache.Clear();
  cache.SetFadeTime(0.0);
  RunFrame(cache, wants, 50.0);
  WaitUntilIdle(cache);
  CHECK(RunFrame(cache, wants, 50.0) == Visibilities({ 1, 1, 1 }));
}

void TestLoading(RelevoCheck& check)
{
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  CHECK(!cache.LoadWanted());
  // Tiles that a caller waits for do not fade in. Neither do those that have begun to.
  const std::vector<Want> first = WithRoot({ { { { 2, 0, 0 } }, 5.0 } });
  RunFrame(cache, first);
  WaitUntilIdle(cache);
  CHECK(RunFrame(cache, first) == Visibilities({ 1, 1, 0 }));
  CHECK(cache.LoadWanted());
  CHECK(!cache.LoadWanted());
  CHECK(RunFrame(cache, first) == Visibilities({ 1, 1, 1 }));
  const std::vector<Want> wants =
    WithRoot({ { { { 2, 0, 0 } }, 5.0 }, { { { 2, 1, 0 } }, 4.0 }, { { { 2, 2, 0 } }, 3.0 } });
  cache.SetMemoryLimit(SizeOf(4));
  CHECK(RunFrame(cache, wants) == Visibilities({ 1, 1, 1, -1, -1 }));
  CHECK(cache.LoadWanted());
  CHECK(!cache.LoadWanted());
  CHECK(RunFrame(cache, wants) == Visibilities({ 1, 1, 1, 1, -1 }));
  CHECK(!cache.LoadWanted());

  // Requests that a smaller limit prevents are not waited for.
  cache.SetMemoryLimit(SizeOf(5));
  store.Close();
  RunFrame(cache, wants);
  store.WaitForStarted(5);
  RunFrame(cache, WithRoot({ { { { 1, 0, 0 } }, 9.0 }, { { { 1, 1, 0 } }, 8.0 } }));
  cache.SetMemoryLimit(SizeOf(2));
  store.Open();
  cache.LoadWanted();
  cache.BeginFrame(1.0);
  CHECK_EQUAL(cache.GetMemorySize(), SizeOf(2));
  cache.EndFrame();
}

// Results of reads from before Clear() are dropped.
void TestClear(RelevoCheck& check, bool isBad)
{
  CHECK_CASE(isBad);
  TileStore store;
  HeightTileCache cache(ReadFrom(store));
  const Position tile = { { RootLevel, 0, 0 } };
  store.SetBad(isBad ? std::vector<Position>{ tile } : std::vector<Position>{});
  store.Close();
  RunFrame(cache, { { tile, Infinite } });
  store.WaitForStarted(1);
  cache.Clear();
  CHECK_EQUAL(cache.GetMemorySize(), SizeOf(1));
  store.Open();
  WaitUntilIdle(cache);
  CHECK_EQUAL(cache.GetMemorySize(), 0);
  CHECK(!cache.NeedsFrame());
  CHECK_EQUAL(cache.TakeError(), "");
  store.SetBad({});
  CHECK(RunFrames(cache, WithRoot({})) == Visibilities({ 1, 1 }));
}

// The end waits for the reads in progress, but not for all requests.
void TestEnd(RelevoCheck& check)
{
  TileStore store;
  store.Close();
  std::atomic<bool> hasEnded{ false };
  std::thread permits;
  const int requests = 900;
  {
    HeightTileCache cache(ReadFrom(store));
    std::vector<Want> wants;
    for (int i = 0; i < requests; ++i)
    {
      wants.push_back({ { { 2, i, 0 } }, 5.0 });
    }
    RunFrame(cache, wants);
    store.WaitForStarted(GetNumberOfWorkers());
    permits = std::thread(
      [&store, &hasEnded]
      {
        while (!hasEnded)
        {
          store.Permit();
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
      });
  }
  CHECK_EQUAL(store.NumberOfReading, 0);
  CHECK(store.GetStarted().size() < requests);
  hasEnded = true;
  permits.join();
}
}

int TestHeightTileCache(int, char*[])
{
  RelevoCheck check;
  TestLimit(check, 16 << 20);
  TestImageryLimit(check, SizeOf(20));
  TestImageryLimit(check, std::size_t(1) << 24);
  TestImageryReplacement(check);
  TestLimit(check, HeightTileCache::BytesPerTile);
  TestLimit(check, HeightTileCache::BytesPerTile - 1);
  TestOrder(check);
  TestNeighbors(check);
  TestReplacement(check);
  TestHangingRead(check);
  TestErrors(check);
  TestRetry(check);
  TestNumberOfReads(check);
  TestHangingEnd(check);
  TestFade(check);
  TestLoading(check);
  TestClear(check, false);
  TestClear(check, true);
  TestEnd(check);
  return check.GetResult();
}

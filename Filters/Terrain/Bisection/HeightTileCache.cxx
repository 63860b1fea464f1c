// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/HeightTileCache.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <new>
#include <system_error>
#include <tuple>
#include <utility>

namespace relevo
{
namespace
{
constexpr unsigned int MaximumWorkers = 4;

// A wanted tile is replaced only by one whose error is larger by this factor. Otherwise two tiles
// with nearly the same error would replace each other in every frame.
constexpr double ReplacementFactor = 1.25;

// Seconds until an unreadable tile is requested again, for the first time and at most.
constexpr double ShortestRetry = 10.0;
constexpr double LongestRetry = 300.0;

// A read that takes longer may hang.
constexpr std::chrono::seconds LongestRead(2);

// Parts of keys, see GetTileKey().
constexpr int KindShift = 62;
constexpr int LevelShift = 56;

TerrainTile::Kind GetKeyKind(std::uint64_t key)
{
  return static_cast<TerrainTile::Kind>(key >> KindShift);
}

int GetKeyLevel(std::uint64_t key)
{
  return static_cast<int>(key >> LevelShift & 63) + TerrainTile::FinestLevel;
}

std::array<int, 2> GetKeyPosition(std::uint64_t key)
{
  constexpr std::uint64_t mask = (std::uint64_t(1) << 28) - 1;
  return { { static_cast<int>(key & mask), static_cast<int>(key >> 28 & mask) } };
}

// Whether a position comes before another one along a Z-order curve: the coordinate whose
// difference has the highest bit decides.
bool IsEarlierOnCurve(const std::array<int, 2>& a, const std::array<int, 2>& b)
{
  const int columns = a[0] ^ b[0];
  const int rows = a[1] ^ b[1];
  const bool isByColumn = rows < columns && rows < (rows ^ columns);
  return isByColumn ? a[0] < b[0] : a[1] < b[1];
}

std::unique_ptr<TerrainTile> MakeTile(std::uint64_t key)
{
  std::unique_ptr<TerrainTile> tile;
  if (GetKeyKind(key) == TerrainTile::Kind::Heights)
  {
    tile = std::make_unique<HeightTile>();
  }
  else
  {
    tile = std::make_unique<ImageryTile>();
  }
  tile->Level = GetKeyLevel(key);
  const std::array<int, 2> position = GetKeyPosition(key);
  tile->Column = position[0];
  tile->Row = position[1];
  return tile;
}
}

// A worker in a read that hangs owns the queue after the cache is gone.
struct HeightTileCache::Queue
{
  struct Request
  {
    std::unique_ptr<TerrainTile> Tile;
    bool IsRead = false;
    bool IsCancelled = false;
  };
  struct Failure
  {
    bool HasFailed = false;
    std::string Error; // until it is taken
  };

  Queue(Reader read, ImageryReader readImagery)
    : Read(std::move(read))
    , ReadImagery(std::move(readImagery))
  {
  }
  bool CanStart() const
  {
    return !this->Requests.empty() && this->Used < this->Limit &&
      this->Running.size() < this->NumberOfReads;
  }
  bool CanGoOn() const { return !this->Running.empty() || this->CanStart(); }
  bool ReadTile(TerrainTile& tile, std::string& error) const;
  void Work();

  const Reader Read;
  const ImageryReader ReadImagery;

  mutable std::mutex Mutex; // protects the next members
  std::condition_variable Changed;
  std::list<Request> Requests; // the next one first
  std::list<Request> Running;
  std::list<Request> Finished;
  std::size_t Used = 0;                                      // tiles in memory or being read
  std::size_t Limit = (std::size_t(1) << 28) / BytesPerTile; // of the former
  std::array<Failure, 2> Failures;                           // by kind
  std::size_t NumberOfReads = GetMaximumNumberOfReads();     // at the same time
  std::size_t NumberOfWorkers = 0;
  bool IsToEnd = false;
};

// An exception that leaves a thread ends the program.
bool HeightTileCache::Queue::ReadTile(TerrainTile& tile, std::string& error) const
{
  const bool isHeights = tile.GetKind() == TerrainTile::Kind::Heights;
  const char* name = isHeights ? "a tile of heights" : "a tile of imagery";
  try
  {
    return isHeights ? this->Read(static_cast<HeightTile&>(tile), error)
                     : this->ReadImagery(static_cast<ImageryTile&>(tile), error);
  }
  catch (const std::bad_alloc&)
  {
    error = std::string("there is not enough memory to read ") + name;
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  catch (...)
  {
    error = std::string(name) + " cannot be read";
  }
  return false;
}

HeightTileCache::HeightTileCache(Reader read, ImageryReader readImagery)
  : Shared(std::make_shared<Queue>(std::move(read), std::move(readImagery)))
{
}

HeightTileCache::~HeightTileCache()
{
  Queue& queue = *this->Shared;
  std::unique_lock<std::mutex> lock(queue.Mutex);
  queue.IsToEnd = true;
  queue.Changed.notify_all();
  const bool haveEnded =
    queue.Changed.wait_for(lock, LongestRead, [&queue] { return queue.NumberOfWorkers == 0; });
  lock.unlock();
  for (std::thread& worker : this->Workers)
  {
    haveEnded ? worker.join() : worker.detach();
  }
}

void HeightTileCache::SetMemoryLimit(std::size_t bytes)
{
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->Limit = bytes / BytesPerTile;
  }
  this->Shared->Changed.notify_all();
}

int HeightTileCache::GetMaximumNumberOfReads()
{
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, MaximumWorkers));
}

void HeightTileCache::SetNumberOfReads(int number)
{
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->NumberOfReads = static_cast<std::size_t>(number);
  }
  this->Shared->Changed.notify_all();
}

bool HeightTileCache::IsCoarsest(const Item& item) const
{
  const TerrainTile::Kind kind = GetKeyKind(item.first);
  return GetKeyLevel(item.first) >=
    this->CoarsestLevels[static_cast<int>(kind)] - (kind == TerrainTile::Kind::Heights ? 1 : 0);
}

float HeightTileCache::GetVisibility(const Entry& entry) const
{
  return entry.IsFading && this->FadeTime > 0.0
    ? static_cast<float>(std::clamp((this->Now - entry.FirstSeen) / this->FadeTime, 0.0, 1.0))
    : 1.0f;
}

void HeightTileCache::BeginFrame(double now)
{
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->DropGivenUp();
    this->TakeIn();
    if (this->Shared->Used > this->Shared->Limit)
    {
      for (const Item* item : this->SortForRemoval())
      {
        if (this->Shared->Used > this->Shared->Limit)
        {
          this->Drop(item->first);
        }
      }
    }
  }
  this->Shared->Changed.notify_all();
  this->Now = now;
  ++this->Frame;
}

const HeightTile* HeightTileCache::Get(
  int level, int column, int row, double error, float& visibility)
{
  return static_cast<const HeightTile*>(
    this->Find(TerrainTile::Kind::Heights, level, column, row, error, visibility));
}

const ImageryTile* HeightTileCache::GetImagery(
  int level, int column, int row, double error, float& visibility)
{
  return static_cast<const ImageryTile*>(
    this->Find(TerrainTile::Kind::Imagery, level, column, row, error, visibility));
}

const TerrainTile* HeightTileCache::Find(
  TerrainTile::Kind kind, int level, int column, int row, double error, float& visibility)
{
  int& coarsest = this->CoarsestLevels[static_cast<int>(kind)];
  coarsest = std::max(coarsest, level);
  Item& item = *this->Tiles.try_emplace(GetTileKey(kind, level, column, row)).first;
  Entry& entry = item.second;
  if (!this->IsWanted(entry))
  {
    entry.LastWanted = this->Frame;
    entry.Error = 0.0;
  }
  entry.Error = std::max(entry.Error, error);
  if (entry.Is == State::Unreadable)
  {
    this->UpdateRetry(entry);
  }
  if (entry.Is != State::InMemory)
  {
    visibility = 0.0f;
    return nullptr;
  }
  if (this->IsCoarsest(item))
  {
    entry.IsFading = false; // there is no coarser surface to begin with
  }
  if (!entry.IsSeen)
  {
    entry.IsSeen = true;
    entry.FirstSeen = this->Now;
  }
  visibility = this->GetVisibility(entry);
  return entry.Tile.get();
}

void HeightTileCache::UpdateRetry(Entry& entry) const
{
  if (entry.RetryTime == 0.0)
  {
    entry.RetryTime = this->Now +
      std::min(LongestRetry, std::ldexp(ShortestRetry, std::min(entry.NumberOfFailures - 1, 10)));
  }
  else if (this->Now >= entry.RetryTime)
  {
    entry.Is = State::Missing;
  }
}

void HeightTileCache::EndFrame()
{
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->CancelRequests();
    this->MakePlan();
    this->StartWorkers();
  }
  this->Shared->Changed.notify_all();
}

void HeightTileCache::CancelRequests()
{
  for (const Queue::Request& request : this->Shared->Requests)
  {
    this->Tiles.at(GetTileKey(*request.Tile)).Is = State::Missing;
  }
  this->Shared->Requests.clear();
  for (auto entry = this->Tiles.begin(); entry != this->Tiles.end();)
  {
    const bool isIdle = entry->second.Is == State::Missing && !this->IsWanted(entry->second);
    entry = isIdle ? this->Tiles.erase(entry) : std::next(entry);
  }
}

// Tiles in memory; the next one to go first.
std::vector<HeightTileCache::Item*> HeightTileCache::SortForRemoval()
{
  std::vector<Item*> items;
  for (Item& item : this->Tiles)
  {
    if (item.second.Is == State::InMemory)
    {
      items.push_back(&item);
    }
  }
  const auto getRank = [this](const Item& item)
  {
    return std::make_tuple(
      this->IsCoarsest(item), item.second.LastWanted, item.second.Error, item.first);
  };
  std::sort(items.begin(), items.end(),
    [&getRank](const Item* a, const Item* b) { return getRank(*a) < getRank(*b); });
  return items;
}

// Wanted tiles; the next one to read first.
std::vector<HeightTileCache::Item*> HeightTileCache::SortMissing()
{
  std::vector<Item*> items;
  for (Item& item : this->Tiles)
  {
    if (item.second.Is == State::Missing && this->IsWanted(item.second))
    {
      items.push_back(&item);
    }
  }
  std::sort(items.begin(), items.end(),
    [](const Item* a, const Item* b)
    { return std::tie(a->second.Error, a->first) > std::tie(b->second.Error, b->first); });
  return items;
}

// Missing tiles that there is room for, or that replace others.
std::vector<HeightTileCache::Item*> HeightTileCache::ChooseMissing()
{
  const std::vector<Item*> missing = this->SortMissing();
  auto room =
    static_cast<std::int64_t>(this->Shared->Limit) - static_cast<std::int64_t>(this->Shared->Used);
  std::vector<Item*> present;
  if (room < static_cast<std::int64_t>(missing.size()))
  {
    present = this->SortForRemoval();
  }
  std::vector<Item*> chosen;
  auto next = present.begin();
  for (Item* item : missing)
  {
    for (; room <= 0 && next != present.end(); ++next, ++room)
    {
      Item& candidate = **next;
      if (this->IsCoarsest(candidate))
      {
        return chosen;
      }
      if (!this->IsWanted(candidate.second))
      {
        this->Drop(candidate.first);
      }
      else if (ReplacementFactor * candidate.second.Error < item->second.Error)
      {
        candidate.second.IsGivenUp = true; // this frame still uses the tile
      }
      else
      {
        return chosen;
      }
    }
    if (room <= 0)
    {
      return chosen;
    }
    --room;
    chosen.push_back(item);
  }
  return chosen;
}

// Neighbouring tiles whose errors are similar are read one after the other, because they need the
// same blocks of the file.
void HeightTileCache::MakePlan()
{
  std::vector<Item*> chosen = this->ChooseMissing();
  const auto getRank = [](const Item& item)
  { return std::make_tuple(std::logb(item.second.Error), item.first >> LevelShift); };
  std::sort(chosen.begin(), chosen.end(),
    [&getRank](const Item* a, const Item* b)
    {
      const auto rank = getRank(*a);
      const auto other = getRank(*b);
      return rank == other ? IsEarlierOnCurve(GetKeyPosition(a->first), GetKeyPosition(b->first))
                           : rank > other;
    });
  for (Item* item : chosen)
  {
    this->Shared->Requests.emplace_back();
    this->Shared->Requests.back().Tile = MakeTile(item->first);
    item->second.Is = State::Requested;
  }
}

void HeightTileCache::Drop(std::uint64_t key)
{
  this->Tiles.erase(key);
  --this->Shared->Used;
}

void HeightTileCache::DropGivenUp()
{
  for (auto entry = this->Tiles.begin(); entry != this->Tiles.end();)
  {
    if (entry->second.IsGivenUp)
    {
      entry = this->Tiles.erase(entry);
      --this->Shared->Used;
    }
    else
    {
      ++entry;
    }
  }
}

void HeightTileCache::TakeIn()
{
  for (Queue::Request& request : this->Shared->Finished)
  {
    Entry& entry = this->Tiles.at(GetTileKey(*request.Tile));
    entry.Is = request.IsRead ? State::InMemory : State::Unreadable;
    if (request.IsRead)
    {
      entry.Tile = std::move(request.Tile);
    }
    else
    {
      ++entry.NumberOfFailures;
      entry.RetryTime = 0.0;
    }
  }
  this->Shared->Finished.clear();
}

bool HeightTileCache::LoadWanted(const std::function<bool()>& isAborted)
{
  std::unique_lock<std::mutex> lock(this->Shared->Mutex);
  this->DropGivenUp();
  this->Shared->Changed.notify_all();
  const auto isDone = [this] { return !this->Shared->CanGoOn() || this->Workers.empty(); };
  while (!this->Shared->Changed.wait_for(lock, std::chrono::milliseconds(20), isDone))
  {
    lock.unlock();
    if (isAborted && isAborted())
    {
      lock.lock();
      break;
    }
    lock.lock();
  }
  bool hasMore = !this->Shared->Finished.empty();
  this->TakeIn();
  for (Item& item : this->Tiles)
  {
    Entry& entry = item.second;
    if (entry.Is == State::InMemory)
    {
      hasMore = hasMore || (entry.IsSeen && this->GetVisibility(entry) < 1.0f);
      entry.IsFading = false;
    }
  }
  return hasMore;
}

void HeightTileCache::Clear()
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  this->Shared->Requests.clear();
  this->Shared->Finished.clear();
  for (Queue::Request& request : this->Shared->Running)
  {
    request.IsCancelled = true;
  }
  this->Tiles.clear();
  this->Shared->Used = this->Shared->Running.size();
  this->CoarsestLevels = { { TerrainTile::FinestLevel, 0 } };
  this->Shared->Failures = {};
}

bool HeightTileCache::IsLoading() const
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return this->Shared->CanGoOn();
}

bool HeightTileCache::NeedsFrame() const
{
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    if (!this->Shared->Finished.empty())
    {
      return true;
    }
  }
  return std::any_of(this->Tiles.begin(), this->Tiles.end(),
    [this](const Item& item)
    {
      const Entry& entry = item.second;
      return entry.IsGivenUp ||
        (entry.Is == State::InMemory && this->IsWanted(entry) && this->GetVisibility(entry) < 1.0f);
    });
}

bool HeightTileCache::LacksMemory() const
{
  return std::any_of(this->Tiles.begin(), this->Tiles.end(),
    [this](const Item& item)
    { return item.second.Is == State::Missing && this->IsWanted(item.second); });
}

std::size_t HeightTileCache::GetMemorySize() const
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return this->Shared->Used * BytesPerTile;
}

int HeightTileCache::GetNumberOfTiles() const
{
  return static_cast<int>(std::count_if(this->Tiles.begin(), this->Tiles.end(),
    [](const Item& item) { return item.second.Is == State::InMemory; }));
}

std::string HeightTileCache::TakeError(TerrainTile::Kind kind)
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return std::exchange(this->Shared->Failures[static_cast<int>(kind)].Error, std::string());
}

void HeightTileCache::StartWorkers()
{
  const std::size_t number = this->Shared->NumberOfReads;
  const std::size_t needed = this->Shared->Requests.size() + this->Shared->Running.size();
  try
  {
    while (this->Workers.size() < std::min(number, needed))
    {
      this->Workers.emplace_back([queue = this->Shared] { queue->Work(); });
      ++this->Shared->NumberOfWorkers;
    }
  }
  catch (const std::system_error& error)
  {
    Queue::Failure& failure = this->Shared->Failures[static_cast<int>(TerrainTile::Kind::Heights)];
    if (this->Workers.empty() && !failure.HasFailed)
    {
      failure = { true, std::string("no thread can be started to read heights: ") + error.what() };
    }
  }
}

void HeightTileCache::Queue::Work()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  for (;;)
  {
    this->Changed.wait(lock, [this] { return this->IsToEnd || this->CanStart(); });
    if (this->IsToEnd)
    {
      --this->NumberOfWorkers;
      this->Changed.notify_all();
      return;
    }
    const auto request = this->Requests.begin();
    this->Running.splice(this->Running.end(), this->Requests, request);
    ++this->Used;
    lock.unlock();

    std::string error;
    request->IsRead = this->ReadTile(*request->Tile, error);
    if (!request->IsRead)
    {
      request->Tile->Clear();
    }

    lock.lock();
    if (!request->IsRead || request->IsCancelled)
    {
      --this->Used;
    }
    if (request->IsCancelled)
    {
      this->Running.erase(request);
    }
    else
    {
      Failure& failure = this->Failures[static_cast<int>(request->Tile->GetKind())];
      if (!request->IsRead && !failure.HasFailed)
      {
        failure = { true, std::move(error) };
      }
      this->Finished.splice(this->Finished.end(), this->Running, request);
    }
    this->Changed.notify_all();
  }
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightTileCache
 * @brief   reads the tiles of heights and imagery that frames want, within a limit of memory
 *
 * Each frame calls BeginFrame(), then Get() or GetImagery() for every tile that it wants, then
 * EndFrame(). Worker threads read the missing tiles, those with the largest error first, and near
 * ones together among those whose errors have the same power of 2. A frame never waits for them.
 * Heights and imagery share the limit, the threads and the order.
 *
 * The limit holds for the tiles in memory and those that are being read, together. If it is
 * reached, missing tiles replace tiles that the frame did not want, the least recently wanted
 * first, and then wanted tiles whose error is clearly smaller. A frame that wants a tile also wants
 * the coarser tile around it, so coarser tiles outlive finer ones. Height tiles of the two
 * coarsest levels and imagery tiles of the coarsest level are not replaced.
 *
 * A tile that cannot be read is requested again by a frame 10 seconds later, then after 20, 40 and
 * so on, up to 5 minutes.
 *
 * All functions must be called from the same thread, unless they say otherwise. Private to the
 * modules for terrains.
 */
#ifndef HeightTileCache_h
#define HeightTileCache_h

#include "Bisection/HeightTileSource.h"
#include "Bisection/ImageryTileSource.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT HeightTileCache
  : public HeightTileSource
  , public ImageryTileSource
{
public:
  /// Reads the heights of a tile, whose level, column and row are set. Returns false and sets the
  /// error on failure. Worker threads call it, several at a time. If a read hangs, it can outlive
  /// the cache, so that the function must own what it uses.
  using Reader = std::function<bool(HeightTile& tile, std::string& error)>;
  /// The same for the colours of a tile.
  using ImageryReader = std::function<bool(ImageryTile& tile, std::string& error)>;

  /// The memory of a tile in bytes.
  static constexpr std::size_t BytesPerTile =
    std::max(sizeof(HeightTile), sizeof(ImageryTile)) + 4 * TerrainTile::NumberOfVertices;

  /// The number of tiles that are read at the same time, at most.
  static int GetMaximumNumberOfReads();

  explicit HeightTileCache(Reader read, ImageryReader readImagery = {});
  /// Waits for the tiles that are being read, but not for a read that hangs for seconds.
  ~HeightTileCache() override;
  HeightTileCache(const HeightTileCache&) = delete;
  void operator=(const HeightTileCache&) = delete;

  /// Set the limit in bytes. Below the size of one tile, none is read. A smaller limit holds from
  /// the next BeginFrame() on; tiles that are being read may exceed it until they are complete.
  void SetMemoryLimit(std::size_t bytes);

  /// Set the number of tiles that are read at the same time.
  void SetNumberOfReads(int number);

  /// Set the time in seconds in which a tile becomes visible after the first Get(), 0 for at once.
  void SetFadeTime(double seconds) { this->FadeTime = seconds; }

  /// Begin a frame at a time in seconds. Tiles that Get() has returned before may be dropped.
  void BeginFrame(double now);
  /// Returns tiles that are valid until the next call of BeginFrame(), LoadWanted() or Clear().
  const HeightTile* Get(int level, int column, int row, double error, float& visibility) override;
  const ImageryTile* GetImagery(
    int level, int column, int row, double error, float& visibility) override;
  /// Request the tiles that were missing, and cancel earlier requests.
  void EndFrame();

  /**
   * After EndFrame(): wait until all requested tiles are read, or until isAborted() is true. These
   * tiles, and those that are in memory, become visible at once. Returns whether the next frame
   * can find more tiles, or request more.
   */
  bool LoadWanted(const std::function<bool()>& isAborted = {});

  /// Drop all tiles, requests and errors, also of tiles that cannot be read.
  void Clear();

  /// Whether tiles are being read, or will be before the next frame. Thread-safe.
  bool IsLoading() const;
  /// Whether another frame can show or request more: tiles have arrived, they become visible, or
  /// requests wait for tiles that BeginFrame() drops.
  bool NeedsFrame() const;
  /// Whether a tile that the last frame wanted was not requested, because of the limit.
  bool LacksMemory() const;
  /// The memory of the tiles, including those that are being read. Thread-safe.
  std::size_t GetMemorySize() const;
  /// The number of tiles that Get() can return.
  int GetNumberOfTiles() const;

  /// The first error of a kind of tiles since Clear(), once; otherwise empty. Thread-safe.
  std::string TakeError(TerrainTile::Kind kind = TerrainTile::Kind::Heights);

private:
  enum class State
  {
    Missing,
    Requested, // until BeginFrame() takes the tile in
    InMemory,
    Unreadable
  };
  struct Entry
  {
    State Is = State::Missing;
    bool IsFading = true;
    bool IsGivenUp = false;
    double Error = 0.0;           // the largest of a frame
    std::uint64_t LastWanted = 0; // the number of the frame
    bool IsSeen = false;
    double FirstSeen = 0.0; // the time of the first Get()
    double RetryTime = 0.0; // of an unreadable tile, or 0 before a frame has found it so
    int NumberOfFailures = 0;
    std::unique_ptr<TerrainTile> Tile;
  };
  using Entries = std::unordered_map<std::uint64_t, Entry>;
  using Item = Entries::value_type;
  struct Queue; // of requests, which the workers share

  const TerrainTile* Find(
    TerrainTile::Kind kind, int level, int column, int row, double error, float& visibility);
  void UpdateRetry(Entry& entry) const;
  bool IsWanted(const Entry& entry) const { return entry.LastWanted == this->Frame; }
  bool IsCoarsest(const Item& item) const;
  float GetVisibility(const Entry& entry) const;
  std::vector<Item*> SortForRemoval();
  std::vector<Item*> SortMissing();
  void TakeIn();
  void Drop(std::uint64_t key);
  void DropGivenUp();
  void CancelRequests();
  std::vector<Item*> ChooseMissing();
  void MakePlan();
  void StartWorkers();

  double FadeTime = 0.25;
  double Now = 0.0;
  std::uint64_t Frame = 1;
  std::array<int, 2> CoarsestLevels = { { TerrainTile::FinestLevel, 0 } }; // by kind
  Entries Tiles;

  const std::shared_ptr<Queue> Shared;
  std::vector<std::thread> Workers;
};
}

#endif

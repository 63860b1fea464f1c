// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RasterPyramid
 * @brief   an open raster pyramid: its file, its cached tiles, and its index
 *
 * The index is read from a file beside the raster or in a cache folder. If there is none, or it
 * belongs to another state of the raster, threads build it in the background and write it there. An
 * index that cannot be written is used all the same. So is an index with samples that cannot be
 * read, which is not written.
 *
 * The thread that builds the index is stopped when the last user of the pyramid is gone. If it is
 * in a read that hangs, the user does not wait for it: the thread owns the pyramid until the read
 * returns.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef RasterPyramid_h
#define RasterPyramid_h

#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "Pyramid/PyramidFile.h"
#include "Pyramid/PyramidIndex.h"
#include "Pyramid/TileCache.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace relevo
{
class PyramidIndexBuilder;

class RELEVOFILTERSTERRAIN_EXPORT RasterPyramid
{
public:
  /// Returns nullptr and sets `error` if the raster cannot be opened. The memory limit, in bytes,
  /// is that of the threads that build the index; 0 for no limit.
  static std::shared_ptr<RasterPyramid> Open(const std::string& fileName,
    const std::string& cacheFolder, std::string& error, std::int64_t indexMemoryLimit = 0);
  ~RasterPyramid();
  RasterPyramid(const RasterPyramid&) = delete;
  void operator=(const RasterPyramid&) = delete;

  const PyramidFile& GetFile() const { return *this->File; }
  const std::string& GetSignature() const { return this->Signature; }
  TileCache& GetCache() { return this->Cache; }

  /// The columns and rows of tiles of a level.
  std::array<int, 2> GetNumberOfTiles(int level) const;

  /// A tile, from the cache or the file; nullptr and `error` on failure. Thread-safe.
  TileCache::TilePointer GetTile(int level, int column, int row, std::string& error);

  /**
   * Interpolate the samples of level 0 bilinearly, at a column and row that are whole numbers at
   * the centers of samples. Beyond the outermost centers the surface is constant. NaN if a sample
   * that contributes has no data. Returns false and sets `error` on failure. Thread-safe.
   */
  bool Interpolate(double column, double row, double& value, std::string& error);

  //@{
  /// Whether the index is complete; it does not change afterwards.
  bool IsIndexComplete() const { return this->IsComplete; }
  const PyramidIndex& GetIndex() const { return this->Index; }
  /// The fraction of the index that is built.
  double GetProgress() const;
  //@}

  /// The range of heights by few samples, which is known as long as the index is not.
  const std::array<double, 2>& GetEstimatedRange() const { return this->EstimatedRange; }

  //@{
  /// The errors of blocks and the ranges of heights: estimates until the index is complete.
  /// Thread-safe.
  std::shared_ptr<const BlockErrors> GetBlockErrors() const;
  std::shared_ptr<const ElevationRanges> GetElevationRanges() const;
  //@}

  /// Wait for the index until `isAborted` returns true. Returns "" or the error of the build.
  template <typename Function>
  std::string WaitForIndex(const Function& isAborted);
  /// Whether the build has ended, with or without an error.
  bool HasIndexEnded() const;
  /// The error of the build; "" while it runs, and if there is none.
  std::string GetIndexError() const;

private:
  RasterPyramid();
  void MakeEstimates();
  static void StartIndex(const std::shared_ptr<RasterPyramid>& pyramid,
    const std::string& cacheFolder, std::int64_t memoryLimit);
  bool ReadIndex(const std::string& cacheFolder);
  void BuildIndex();
  void StopIndex();
  void UseIndex();

  std::string FileName;
  std::string Signature;
  std::unique_ptr<PyramidFile> File;
  TileCache Cache;
  std::array<double, 2> EstimatedRange{ { 0.0, 0.0 } };

  PyramidIndex Index;
  std::string IndexFileNames[2]; // where to write it: the second, where the first cannot be written
  std::unique_ptr<PyramidIndexBuilder> Builder;
  std::thread Thread;
  std::atomic<bool> Abort{ false };
  std::atomic<bool> IsComplete{ false };
  mutable std::mutex Mutex; // protects the next members
  std::condition_variable Ended;
  bool HasEnded = false;
  std::string Error;
  std::shared_ptr<const BlockErrors> Errors;
  std::shared_ptr<const ElevationRanges> Ranges;
};

template <typename Function>
std::string RasterPyramid::WaitForIndex(const Function& isAborted)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->HasEnded)
  {
    this->Ended.wait_for(lock, std::chrono::milliseconds(50));
    lock.unlock();
    if (isAborted())
    {
      return "";
    }
    lock.lock();
  }
  return this->Error;
}
}

#endif

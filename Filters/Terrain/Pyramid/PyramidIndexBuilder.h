// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidIndexBuilder
 * @brief   measures the tiles of a raster pyramid: ranges, and deviations from full resolution
 *
 * The surface of a level is bilinear between the centers of its samples, and constant beyond the
 * outermost ones. Levels are registered by the ratio of their sizes. On each rectangle between the
 * lines of samples of both levels, the difference of two such surfaces is bilinear, too, so that it
 * is largest at a corner. The builder evaluates all corners; the deviations are exact. Points where
 * either surface has no data do not count. BlockErrorBuilder measures the blocks of the bisection
 * with the same samples.
 *
 * Samples that cannot be read count as missing, in parts of one tile each.
 *
 * Work and memory are proportional to what a sparse file stores. The result is the same for any
 * number of threads.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef PyramidIndexBuilder_h
#define PyramidIndexBuilder_h

#include "Pyramid/BlockErrorBuilder.h"
#include "Pyramid/PyramidFile.h"
#include "Pyramid/PyramidIndex.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT PyramidIndexBuilder
{
public:
  PyramidIndexBuilder(const PyramidFile& file, const std::atomic<bool>& abort);

  /// Set the memory of all threads in bytes; 0 for no limit. One thread works in any case.
  void SetMemoryLimit(std::int64_t bytes) { this->MemoryLimit = bytes; }

  /**
   * Fill in the index with at most this many threads. Returns false after an abort and, with an
   * error, if the memory is not sufficient, if the file changes, or if samples of one of GDAL's
   * virtual files cannot be read. Returns true, with the first error, if samples of another file
   * cannot be read.
   */
  bool Build(int numberOfThreads, PyramidIndex& index, std::string& error);

  /// The fraction of the work that is done. Thread-safe.
  double GetProgress() const;

private:
  enum class Task
  {
    Compare, // samples of level 0 with those of all other levels
    Measure, // the range of samples of another level
    Constant // samples of another level with the absent ones of level 0
  };
  struct Job
  {
    Task What;
    SampleWindow Window;
  };

  void ChooseBlockSize(int numberOfThreads);
  static std::pair<SampleWindow, SampleWindow> Split(
    const SampleWindow& part, int width, int height);
  void CollectBlocks(const SampleWindow& part);
  void CollectRanges(const SampleWindow& part);
  void CollectConstants(const SampleWindow& part, int level);
  SampleWindow GetLevelWindow(const SampleWindow& block, int level) const;
  void RunJobs(int numberOfThreads);
  void Work();
  void Stop(const std::string& error);
  bool IsStopped() const { return this->Abort || this->HasEnded; }
  void Run(const Job& job);
  void CompareBlock(const SampleWindow& block);
  std::unique_ptr<BlockErrorArea> CompareLevels(const SampleWindow& block);
  void Read(const SampleWindow& window, std::vector<double>& samples);
  void MeasureRange(const SampleWindow& window, const std::vector<double>& samples);
  void MeasureDeviation(const SampleWindow& block, const std::vector<double>& fine,
    const SampleWindow& window, const std::vector<double>& coarse);
  void MeasureConstant(const SampleWindow& window, const std::vector<double>& samples);

  const PyramidFile& File;
  const std::atomic<bool>& Abort;
  std::int64_t MemoryLimit = 0;
  std::array<int, 2> BlockSize{ { 1, 1 } };
  std::vector<Job> Jobs;
  std::atomic<std::size_t> NumberOfJobs{ 0 }; // 0 until all are collected
  std::atomic<std::size_t> Next{ 0 };
  std::atomic<std::size_t> Done{ 0 };
  std::mutex Mutex; // protects the next members
  PyramidIndex* Index = nullptr;
  std::string Error;                   // of reading
  std::atomic<bool> HasEnded{ false }; // with an error, before all jobs are done
  BlockErrorBuilder Blocks;            // thread-safe
};
}

#endif

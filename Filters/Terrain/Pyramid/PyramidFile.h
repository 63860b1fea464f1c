// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidFile
 * @brief   a raster and its overviews, read in rectangles by any number of threads
 *
 * GDAL reads the samples. Level 0 is the full resolution; the overviews follow in order of falling
 * size. A GDAL dataset belongs to one thread at a time, so each thread gets one of its own. If
 * these need much memory, threads wait for each other.
 *
 * Threads share the blocks of windows of a few blocks, so that a block that neighbouring windows
 * need is decoded once.
 *
 * If the file changes while it is open, all reads fail, so that old and new samples never mix.
 * After a failed read of one of GDAL's virtual files, the next read opens the file again: a server
 * may have recovered.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef PyramidFile_h
#define PyramidFile_h

#include "Geodesy/GDALSession.h"
#include "Pyramid/BlockCache.h"
#include "Pyramid/SampleWindow.h"
#include "Raster/FileVersion.h"
#include "Raster/RasterDescription.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT PyramidFile
{
public:
  /// Open a raster by any name that GDAL knows. Returns nullptr and sets `error` on failure.
  static std::unique_ptr<PyramidFile> Open(const std::string& fileName, std::string& error);
  ~PyramidFile();
  PyramidFile(const PyramidFile&) = delete;
  void operator=(const PyramidFile&) = delete;

  const RasterDescription& Describe() const { return this->Description; }
  int GetNumberOfLevels() const { return static_cast<int>(this->Sizes.size()); }
  const std::vector<std::array<int, 2>>& GetSizes() const { return this->Sizes; }
  /// Columns and rows of a level.
  const std::array<int, 2>& GetSize(int level) const { return this->Sizes[level]; }

  /// Whether the file stores whole rows rather than tiles, so that a part of a row takes as long.
  bool HasRowBlocks() const { return this->IsStoredInRows && !this->IsRaw; }
  /// Whether all samples fit into floats.
  bool HasFloatSamples() const { return this->IsFloat; }

  //@{
  /**
   * Read samples as stored, without scale and offset, row by row; NaN where data are missing.
   * Returns false and sets `error` on failure. Thread-safe.
   */
  bool Read(const SampleWindow& window, double* samples, std::string& error) const;
  bool Read(const SampleWindow& window, float* samples, std::string& error) const;
  //@}

  /**
   * Whether the file stores no samples of a window, which then all equal GetAbsentSample().
   * Thread-safe.
   */
  bool IsAbsent(const SampleWindow& window) const;
  /// The value of samples that a sparse file does not store: NaN, or 0 without a no-data value.
  double GetAbsentSample() const;

  /// The bytes of memory that this many threads need which read tiles, besides the samples.
  std::int64_t GetMemoryOfReading(int threads) const;

  /// Close the datasets that no thread uses, to release their memory. Thread-safe.
  void CloseIdleHandles() const;

  /// Whether the file is one of GDAL's virtual files, such as a file on a server.
  bool IsVirtual() const { return GDALSession::IsVirtual(this->FileName); }

  /// Whether the file has changed since it was opened. Thread-safe.
  bool HasChanged() const { return this->Version.HasChanged(); }

  /// A text that changes when the file does: its current version and its description.
  std::string GetSignature() const;

private:
  struct Handle;
  class Lease;
  template <typename T>
  class WindowReader;

  PyramidFile();
  GDALDatasetPointer OpenDataset(const GDALSession& session, std::string& error) const;
  void FindLevels(GDALDatasetH dataset);
  std::unique_ptr<Handle> NewHandle(std::string& error) const;
  bool SetBands(Handle& handle, std::string& error) const;
  bool AreBlocksShared(const SampleWindow& window) const;
  std::string DescribeFailure(
    const SampleWindow& window, const GDALSession& session, Lease& lease) const;
  template <typename T>
  bool ReadAs(const SampleWindow& window, T* samples, std::string& error) const;
  template <typename T>
  bool ReadWindow(const SampleWindow& window, T* samples, std::vector<unsigned char>& mask,
    std::string& error) const;

  std::string FileName;
  FileVersion Version;
  RasterDescription Description;
  std::vector<std::array<int, 2>> Sizes;
  std::vector<int> Overviews;                 // GDAL's numbers of the levels; -1 for level 0
  std::vector<std::array<int, 2>> BlockSizes; // of the levels
  GDALDataType StoredType = GDT_Unknown;
  bool IsStoredInRows = false;
  bool IsRaw = false; // parts of rows can be read
  bool IsFloat = false;

  double BytesOfPositions = 0.0; // of blocks, in each dataset
  int MaximumHandles = 1;

  mutable std::mutex Mutex; // protects the next members
  mutable std::condition_variable Returned;
  mutable int HandlesInUse = 0;
  mutable int LargestHandlesInUse = 0;               // since CloseIdleHandles()
  mutable std::vector<std::unique_ptr<Handle>> Free; // handles that no thread uses

  mutable BlockCache Blocks;
};
}

#endif

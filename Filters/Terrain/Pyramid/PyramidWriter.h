// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidWriter
 * @brief   copies a raster into a tiled, compressed BigTIFF and computes its overviews
 *
 * A hidden file beside the target grows, together with a journal of the complete rows. If the
 * program is interrupted, the next run for the same raster and target goes on from there. The file
 * is renamed onto the target when it is complete, and its index is written before. A lock keeps a
 * second process from writing the same file.
 *
 * Each sample of an overview is the mean of the samples with data among the 2 x 2 that it covers.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef PyramidWriter_h
#define PyramidWriter_h

#include "Geodesy/GDALSession.h"
#include "Pyramid/SampleWindow.h"

#include <gdal.h>

#include <functional>
#include <string>
#include <vector>

namespace relevo
{
class PyramidWriter
{
public:
  struct Settings
  {
    std::string Input;
    std::string Output;
    std::string Compression; // of GDAL's driver for GeoTIFF, as DEFLATE
    bool HasIndex = true;
  };
  enum class Step
  {
    Copy,
    Index
  };
  /// Called with the fraction of a step that is complete; returns false to stop.
  using Progress = std::function<bool(Step, double)>;

  PyramidWriter(const Settings& settings, const Progress& progress);
  ~PyramidWriter();
  PyramidWriter(const PyramidWriter&) = delete;
  void operator=(const PyramidWriter&) = delete;

  enum class Result
  {
    Done,
    Stopped,
    Failed
  };
  /// Write the file. If that fails, `error` tells why, and the target is as it was before.
  Result Write(std::string& error);

private:
  class Lock;

  bool OpenInput(std::string& error);
  bool Create(std::string& error);
  bool Resume();
  bool CreateOverviews(std::string& error);
  Result CopyLevels(std::string& error);
  Result CopyLevel(int level, std::string& error);
  bool CopyWindow(const SampleWindow& window, std::string& error);
  bool Reduce(const SampleWindow& window, std::string& error);
  bool Flush(int level, int row, std::string& error);
  Result CloseTarget(std::string& error);
  Result WriteIndex(std::string& error);
  Result Publish(std::string& error);

  GDALRasterBandH GetBand(int level) const;
  bool IsAbsent(GDALRasterBandH band, const SampleWindow& window) const;
  void RemoveTemporaries() const;
  std::string MakeJournalHeader() const;

  Settings Wanted;
  Progress Report;
  std::string TargetName; // the output without symbolic links
  std::string PartialName;
  std::string JournalName;
  std::string LockName;

  GDALDatasetPointer Source;
  GDALDatasetPointer Target;
  GDALDataType Type = GDT_Unknown;
  int Width = 0;
  int Height = 0;
  int BlockSize = 1; // samples per side
  int NumberOfLevels = 1;
  int Level = 0; // the next row to copy
  int Row = 0;
  double DoneSamples = 0.0;
  double AllSamples = 0.0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GDALSession
 * @brief   GDAL ready for use: its messages collected instead of printed, files cut short told
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
 */
#ifndef GDALSession_h
#define GDALSession_h

#include <gdal.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace relevo
{
/**
 * Lives as long as the calls whose messages are wanted, on the thread that makes them. Meanwhile
 * GDAL reads raw files by lines: in larger parts it fills up with zeros what is missing.
 */
class GDALSession
{
public:
  struct Collection
  {
    std::vector<std::string> Texts;
    bool HasFileErrors = false;
  };

  GDALSession();
  ~GDALSession();

  bool HasErrors() const { return !this->Errors.Texts.empty(); }
  /// Whether part of a file could not be read; GDAL may continue all the same.
  bool HasFileErrors() const { return this->Errors.HasFileErrors; }
  /// The errors so far, or `fallback`.
  std::string Messages(const std::string& fallback) const;

private:
  GDALSession(const GDALSession&) = delete;
  void operator=(const GDALSession&) = delete;

  Collection Errors;
  std::optional<std::string> LargeReads; // the option as it was
};

struct GDALCloser
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using GDALDatasetPointer = std::unique_ptr<void, GDALCloser>;
}

#endif

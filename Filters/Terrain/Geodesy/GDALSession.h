// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GDALSession
 * @brief   collects GDAL's messages and detects truncated files
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef GDALSession_h
#define GDALSession_h

#include <gdal.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace relevo
{
/**
 * Create a session on the stack around GDAL calls. It collects the messages of its thread instead
 * of printing them. It also makes GDAL read raw files line by line, because larger reads replace
 * missing data by zeros without an error. VRTs open their sources anew, because sources that two
 * VRTs share cannot be read by two threads.
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
  /// Whether part of a file could not be read. GDAL may continue regardless.
  bool HasFileErrors() const { return this->Errors.HasFileErrors; }
  /// Returns the errors so far, or `fallback` if there are none.
  std::string Messages(const std::string& fallback) const;

private:
  GDALSession(const GDALSession&) = delete;
  void operator=(const GDALSession&) = delete;

  Collection Errors;
  std::array<std::optional<std::string>, 2> PreviousValues; // of options
};

struct GDALCloser
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using GDALDatasetPointer = std::unique_ptr<void, GDALCloser>;
}

#endif

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
 * VRTs share cannot be read by two threads. A server that does not answer is an error after 20
 * seconds, and one that is busy is asked three times, unless the user has set GDAL's options for
 * this.
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

  /// Whether a name is that of a file in one of GDAL's virtual file systems, such as /vsicurl/.
  static bool IsVirtual(const std::string& fileName) { return fileName.rfind("/vsi", 0) == 0; }
  /// Drop what GDAL has cached of a file on a server: contents, and that it could not be read.
  static void ForgetFile(const std::string& fileName);

private:
  GDALSession(const GDALSession&) = delete;
  void operator=(const GDALSession&) = delete;

  Collection Errors;
  std::array<std::optional<std::string>, 2> PreviousValues; // of options
  std::array<bool, 5> IsDefault{};                          // whether the user set no option
};

struct GDALCloser
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using GDALDatasetPointer = std::unique_ptr<void, GDALCloser>;
}

#endif

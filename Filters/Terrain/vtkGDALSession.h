// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGDALSession
 * @brief   GDAL ready for use, its messages collected instead of printed
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
 */
#ifndef vtkGDALSession_h
#define vtkGDALSession_h

#include <gdal.h>

#include <memory>
#include <string>
#include <vector>

namespace relevo
{
/**
 * Lives as long as the calls whose messages are wanted, on the thread that makes them.
 */
class GDALSession
{
public:
  GDALSession();
  ~GDALSession();

  bool HasErrors() const { return !this->Collected.empty(); }
  /// The errors so far, or `fallback`.
  std::string Messages(const std::string& fallback) const;

private:
  GDALSession(const GDALSession&) = delete;
  void operator=(const GDALSession&) = delete;

  std::vector<std::string> Collected;
};

struct GDALCloser
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using GDALDatasetPointer = std::unique_ptr<void, GDALCloser>;
}

#endif

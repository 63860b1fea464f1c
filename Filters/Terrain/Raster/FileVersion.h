// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FileVersion
 * @brief   recognises that the files of a GDAL dataset have changed since they were opened
 *
 * A version consists of the size, the time and, on Linux, the inode of each file: the raster, the
 * sources of a VRT, and overviews in a file of their own. It does not include statistics that other
 * programs write into .aux.xml files. GDAL caches the properties of files on servers, so that
 * changes there are not recognised.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef FileVersion_h
#define FileVersion_h

#include <gdal.h>

#include <string>
#include <vector>

namespace relevo
{
class FileVersion
{
public:
  FileVersion() = default;
  /// The version of a file, and of the other files of a dataset that has been opened from it.
  explicit FileVersion(const std::string& fileName, GDALDatasetH dataset = nullptr);

  /// Whether a file has another version now. A file that has been removed does not count, because
  /// datasets that have it open can still read it. Thread-safe.
  bool HasChanged() const;

  /// The versions of all files, as they are now. Thread-safe.
  std::string DescribeCurrent() const;

private:
  std::vector<std::string> Names; // the raster first
  std::vector<std::string> Texts;
};
}

#endif

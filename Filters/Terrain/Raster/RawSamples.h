// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RawSamples
 * @brief   the samples of an uncompressed file that a separate header describes
 *
 * The drivers of GDAL for such files, such as VRT and ENVI, read and cache whole rows. This class
 * reads the part of each row that is needed.
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef RawSamples_h
#define RawSamples_h

#include <cpl_vsi.h>
#include <gdal.h>

#include <memory>
#include <vector>

namespace relevo
{
class RawSamples
{
public:
  /// Opens the file of the first band of a dataset. Returns nullptr if it is not such a file, or
  /// its layout is not supported.
  static std::unique_ptr<RawSamples> Open(GDALDatasetH dataset);
  ~RawSamples();
  RawSamples(const RawSamples&) = delete;
  void operator=(const RawSamples&) = delete;

  /// Reads a rectangle, row by row, converted to a type. Returns false if the file is too short.
  bool Read(int column, int row, int width, int height, GDALDataType type, unsigned char* samples);

private:
  RawSamples() = default;

  VSILFILE* File = nullptr;
  GDALDataType Type = GDT_Unknown;
  bool IsSwapped = false; // from the byte order of the machine
  long long Start = 0;    // of the first sample in the file
  long long PixelOffset = 0;
  long long LineOffset = 0;
  std::vector<unsigned char> Line;
};
}

#endif

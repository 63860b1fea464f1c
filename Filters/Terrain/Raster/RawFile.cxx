// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/RawFile.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <algorithm>

namespace relevo
{
std::string FindTruncation(GDALDatasetH dataset)
{
  GDALDataset::RawBinaryLayout layout;
  VSIStatBufL file;
  if (!GDALDataset::FromHandle(dataset)->GetRawBinaryLayout(layout) ||
    VSIStatL(layout.osRawFilename.c_str(), &file) != 0)
  {
    return "";
  }
  // Offsets can be negative, for example if rows are stored from last to first.
  const auto extent = [](long long offset, int count)
  { return std::max(0LL, offset * (count - 1)); };
  const long long needed = static_cast<long long>(layout.nImageOffset) +
    extent(layout.nPixelOffset, GDALGetRasterXSize(dataset)) +
    extent(layout.nLineOffset, GDALGetRasterYSize(dataset)) +
    extent(layout.nBandOffset, GDALGetRasterCount(dataset)) +
    GDALGetDataTypeSizeBytes(layout.eDataType);
  if (file.st_size >= needed)
  {
    return "";
  }
  return "the file is truncated: it has " + std::to_string(file.st_size) + " of " +
    std::to_string(needed) + " bytes";
}
}

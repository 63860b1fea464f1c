// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/RawFile.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cstdlib>

namespace relevo
{
namespace
{
// Looking at all blocks would take long for large files.
constexpr int BlocksPerSide = 8;

// The position in the file after a block of a TIFF file; 0 if the block is not stored.
long long FindEndOfBlock(GDALRasterBandH band, int column, int row)
{
  const auto get = [&](const char* item)
  {
    const std::string name =
      std::string(item) + "_" + std::to_string(column) + "_" + std::to_string(row);
    const char* text = GDALGetMetadataItem(band, name.c_str(), "TIFF");
    return text ? std::atoll(text) : 0LL;
  };
  const long long offset = get("BLOCK_OFFSET");
  return offset > 0 ? offset + get("BLOCK_SIZE") : 0;
}

// The largest position after some blocks, among them the last one.
long long FindEndOfBlocks(GDALRasterBandH band)
{
  int size[2];
  GDALGetBlockSize(band, &size[0], &size[1]);
  const int columns = (GDALGetRasterBandXSize(band) - 1) / size[0] + 1;
  const int rows = (GDALGetRasterBandYSize(band) - 1) / size[1] + 1;
  const int steps[2] = { (columns - 1) / BlocksPerSide + 1, (rows - 1) / BlocksPerSide + 1 };
  long long end = 0;
  for (int row = rows - 1; row >= 0; row -= steps[1])
  {
    for (int column = columns - 1; column >= 0; column -= steps[0])
    {
      end = std::max(end, FindEndOfBlock(band, column, row));
    }
  }
  return end;
}

// The file must have at least so many bytes; 0 if this is not known. Files on servers and in
// archives are not examined.
long long FindEndOfTIFF(GDALDatasetH dataset)
{
  const std::string driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  const std::string name = GDALGetDescription(dataset);
  if (driver != "GTiff" || name.compare(0, 4, "/vsi") == 0)
  {
    return 0;
  }
  VSIStatBufL overviews;
  const bool hasOverviewFile = VSIStatL((name + ".ovr").c_str(), &overviews) == 0;
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  long long end = band ? FindEndOfBlocks(band) : 0;
  for (int i = 0; band && !hasOverviewFile && i < GDALGetOverviewCount(band); ++i)
  {
    const GDALRasterBandH overview = GDALGetOverview(band, i);
    end = std::max(end, overview ? FindEndOfBlocks(overview) : 0);
  }
  return end;
}
}

std::string FindTruncation(GDALDatasetH dataset)
{
  const long long end = FindEndOfTIFF(dataset);
  VSIStatBufL tiff;
  if (end > 0 && VSIStatL(GDALGetDescription(dataset), &tiff) == 0 && tiff.st_size < end)
  {
    return "the file is truncated: it has " + std::to_string(tiff.st_size) + " of at least " +
      std::to_string(end) + " bytes";
  }
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

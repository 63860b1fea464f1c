// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Raster
 * @brief   one band of a raster file, read row by row in the type it is stored in
 *
 * Private to the modules' own sources.
 */
#ifndef Raster_h
#define Raster_h

#include "Raster/RasterDescription.h"

#include <memory>
#include <string>

namespace relevo
{
/**
 * The file in a name that GDAL gives to a raster of a container, such as NETCDF:"file.nc":band or
 * GTIFF_DIR:2:file.tif. Any other name is returned as it is.
 */
std::string FindContainer(const std::string& name);

class Raster
{
public:
  /**
   * Opens a file; nullptr, and why in `error`, when that cannot be done.
   *
   * OpenImageIO reads the pixels of every format it knows. GDAL, where it was built in, reads
   * the others and gives the georeference, the no-data value, scale and offset. It also reads the
   * formats that GDALRaster::Claims() and what OpenImageIO does not support: validity masks and
   * samples with fewer bits than their type.
   */
  static std::unique_ptr<Raster> Open(const std::string& fileName, std::string& error);

  virtual ~Raster() = default;

  const RasterDescription& Describe() const { return this->Contents; }

  /**
   * Selects a smaller version of the raster in the same file (overviews, mip levels): the smallest
   * of at least this size. Rows and their description are then those of that version; the location
   * stays. Does nothing where there is none.
   */
  virtual void SelectLevel(int width, int height) = 0;

  /**
   * Reads rows [first, first + count) of the file, Width samples of the described type each.
   */
  virtual bool ReadRows(int first, int count, void* samples, std::string& error) = 0;

  /**
   * Reads the mask of those rows, 0 where there is no data.
   */
  virtual bool ReadMask(int first, int count, unsigned char* mask, std::string& error);

protected:
  Raster() = default;
  Raster(const Raster&) = delete;
  void operator=(const Raster&) = delete;

  /// Whether a version of that size is smaller than the one in use, and large enough.
  bool IsBetterLevel(int levelWidth, int levelHeight, int width, int height) const;

  RasterDescription Contents;
};
}

#endif

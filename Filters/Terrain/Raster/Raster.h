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

#include "Geodesy/Georeference.h"

#include <memory>
#include <optional>
#include <string>

namespace relevo
{
/// What a file says about its first band.
struct RasterDescription
{
  int Width = 0;
  int Height = 0;
  int RowsPerBlock = 1;    ///< reading whole multiples of these rows is efficient
  int SamplesPerTexel = 1; ///< that are read, not only kept
  int Type = 0;            ///< VTK's type of the samples as read
  bool HasMask = false;    ///< validity comes from a mask as well
  std::optional<double> NoData;
  double Scale = 1.0; ///< height = Scale * sample + Offset
  double Offset = 0.0;
  double VerticalUnit = 1.0; ///< metres in one unit of the heights
  Georeference Location;
};

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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GDALRaster
 * @brief   first band and georeference of a raster, read with GDAL
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef GDALRaster_h
#define GDALRaster_h

#include "Raster/Raster.h"

namespace relevo
{
class GDALRaster : public Raster
{
public:
  /**
   * Returns nullptr with an `error` if GDAL cannot open the file.
   */
  static std::unique_ptr<GDALRaster> Open(const std::string& fileName, std::string& error);

  /// Describe the first band of a GDAL dataset. Returns false with an error if it is not supported.
  static bool Describe(void* dataset, RasterDescription& contents, std::string& error);

  GDALRaster();
  ~GDALRaster() override;

  /**
   * Whether the file has a format that only GDAL reads, even if the file is broken. These are PNG,
   * because libpng prints errors to stderr when OpenImageIO calls it, and JPEG, because OpenImageIO
   * does not report truncated files.
   */
  static bool Claims(const std::string& fileName);

  void SelectLevel(int width, int height) override;
  bool ReadRows(int first, int count, void* samples, std::string& error) override;
  bool ReadMask(int first, int count, unsigned char* mask, std::string& error) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif

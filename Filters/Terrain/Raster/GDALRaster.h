// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GDALRaster
 * @brief   a raster's first band and its georeference through GDAL
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
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
   * nullptr, and why in `error`, when GDAL cannot open the file.
   */
  static std::unique_ptr<GDALRaster> Open(const std::string& fileName, std::string& error);

  GDALRaster();
  ~GDALRaster() override;

  /**
   * Whether the file is, broken or not, of a format that is left to GDAL: PNG, because libpng
   * writes its errors on stderr when OpenImageIO calls it, and JPEG, because OpenImageIO does not
   * say when a file is truncated.
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

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
class Raster
{
public:
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

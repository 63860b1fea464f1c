// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Raster
 * @brief   one band of a raster file, read by rows in its stored type
 *
 * Private to the module.
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
   * Selects the smallest overview or mip level of the file that has at least the given size, if
   * there is one. ReadRows() and Describe() then refer to that level. The location does not change.
   */
  virtual void SelectLevel(int width, int height) = 0;

  /**
   * Reads the rows [first, first + count), each with Width samples of the described type.
   */
  virtual bool ReadRows(int first, int count, void* samples, std::string& error) = 0;

  /**
   * Reads the mask of the rows, which is 0 where data is missing.
   */
  virtual bool ReadMask(int first, int count, unsigned char* mask, std::string& error);

protected:
  Raster() = default;
  Raster(const Raster&) = delete;
  void operator=(const Raster&) = delete;

  /// Whether a level is smaller than the current one and large enough.
  bool IsBetterLevel(int levelWidth, int levelHeight, int width, int height) const;

  RasterDescription Contents;
};
}

#endif

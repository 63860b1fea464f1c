// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ImageryOptions
 * @brief   which image to drape over a terrain, and what to read from it
 *
 * Private to the modules for terrains.
 */
#ifndef ImageryOptions_h
#define ImageryOptions_h

#include <array>
#include <string>

namespace relevo
{
struct ImageryOptions
{
  std::string FileName;
  /// Bands for red, green and blue, from 1; all 0 to use those that the file declares.
  std::array<int, 3> Bands = { { 0, 0, 0 } };
  /// Read the numbers of the first band instead of colours.
  bool HasNumbers = false;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SampleWindow
 * @brief   a rectangle of samples of one level of a raster pyramid
 *
 * Private to the module.
 */
#ifndef SampleWindow_h
#define SampleWindow_h

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t

namespace relevo
{
struct SampleWindow
{
  int Level = 0;
  int Column = 0; // of the first sample
  int Row = 0;
  int Width = 0;
  int Height = 0;

  std::size_t GetNumberOfSamples() const
  {
    return static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Height);
  }
};
}

#endif

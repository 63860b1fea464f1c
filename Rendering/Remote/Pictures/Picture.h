// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   pictures of a window, raw and encoded
 */
#ifndef Picture_h
#define Picture_h

#include <cstdint>
#include <vector>

namespace relevo
{
struct RawPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels; // red, green, blue; the lowest row first
  std::uint64_t Frame = 0;           // number of the window's frame
  bool IsLossless = false;           // how to encode it
};

/// A JPEG file, or a PNG file if it is lossless.
struct EncodedPicture
{
  std::uint64_t Frame = 0;
  bool IsLossless = false;
  std::vector<unsigned char> Data;
};
}

#endif

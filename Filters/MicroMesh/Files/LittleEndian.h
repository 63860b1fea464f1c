// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   numbers in files: little-endian, of 1 to 8 bytes, without a sign
 */
#ifndef LittleEndian_h
#define LittleEndian_h

#include <cstdint>
#include <string>
#include <string_view>

namespace relevo
{
inline void AppendNumber(std::string& bytes, std::uint64_t number, std::size_t width)
{
  for (std::size_t i = 0; i < width; ++i)
  {
    bytes.push_back(static_cast<char>(number >> 8 * i & 255));
  }
}

/// Read a number and remove its bytes. Returns 0 if there are too few, which are removed.
inline std::uint64_t TakeNumber(std::string_view& bytes, std::size_t width)
{
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < width && bytes.size() >= width; ++i)
  {
    number |= std::uint64_t{ static_cast<unsigned char>(bytes[i]) } << 8 * i;
  }
  bytes.remove_prefix(width < bytes.size() ? width : bytes.size());
  return number;
}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lists of bits in bytes. The first bit of a byte is its lowest one.
 */
#ifndef BitList_h
#define BitList_h

#include <cstddef>
#include <string>
#include <string_view>

namespace relevo
{
/// The number of bytes of a list.
inline std::size_t GetBitListSize(std::size_t bits)
{
  return (bits + 7) / 8;
}

/// Adds a bit to a list of `size` bits, which is as long as GetBitListSize() says.
inline void AppendBit(bool bit, std::size_t size, std::string& bytes)
{
  if (size % 8 == 0)
  {
    bytes.push_back('\0');
  }
  bytes.back() = static_cast<char>(bytes.back() | (bit ? 1 : 0) << size % 8);
}

inline bool IsBitSet(std::string_view bytes, std::size_t i)
{
  return (static_cast<unsigned char>(bytes[i / 8]) >> i % 8 & 1) != 0;
}
}

#endif

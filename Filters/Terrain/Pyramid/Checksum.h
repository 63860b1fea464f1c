// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the 64-bit hash FNV-1a of bytes
 *
 * Private to the module.
 */
#ifndef Checksum_h
#define Checksum_h

#include <cstdint>
#include <string_view>

namespace relevo
{
inline std::uint64_t GetChecksum(std::string_view bytes)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const char byte : bytes)
  {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  }
  return hash;
}
}

#endif

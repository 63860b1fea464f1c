// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   keys of maps for columns and rows
 *
 * Private to the modules for terrains.
 */
#ifndef GridKey_h
#define GridKey_h

#include <cstdint>

namespace relevo
{
/// Both numbers must be in [0, 2^32).
inline std::uint64_t MakeGridKey(std::int64_t column, std::int64_t row)
{
  return static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint64_t>(column);
}

inline int GetKeyColumn(std::uint64_t key)
{
  return static_cast<int>(key & 0xffffffffu);
}

inline int GetKeyRow(std::uint64_t key)
{
  return static_cast<int>(key >> 32);
}
}

#endif

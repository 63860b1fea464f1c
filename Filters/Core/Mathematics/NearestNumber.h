// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   a computed value as an array's type has it
 *
 * Private to the modules' own sources.
 */
#ifndef NearestNumber_h
#define NearestNumber_h

#include <cmath>
#include <limits>
#include <type_traits>

namespace relevo
{
/// Integers are rounded, and end where their type does.
template <typename T>
T getNearestNumber(double value)
{
  if constexpr (std::is_integral<T>::value)
  {
    // The largest 64-bit integers have no double of their own: compare before converting.
    const double rounded = std::round(value);
    if (rounded <= static_cast<double>(std::numeric_limits<T>::lowest()))
    {
      return std::numeric_limits<T>::lowest();
    }
    return rounded >= static_cast<double>(std::numeric_limits<T>::max())
      ? std::numeric_limits<T>::max()
      : static_cast<T>(rounded);
  }
  else
  {
    return static_cast<T>(value);
  }
}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   converts a computed value to an array's type
 */
#ifndef NearestNumber_h
#define NearestNumber_h

#include <cmath>
#include <limits>
#include <type_traits>

namespace relevo
{
/// Round to integers and clamp to the range of the type.
template <typename T>
T getNearestNumber(double value)
{
  if constexpr (std::is_integral<T>::value)
  {
    // The largest 64-bit integers are not representable as doubles: compare before converting.
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

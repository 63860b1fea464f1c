// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a declared no-data value as samples of a raster store it
 *
 * Private to the module.
 */
#ifndef StoredNoData_h
#define StoredNoData_h

#include <algorithm> // for std::clamp
#include <cmath>     // for std::isfinite
#include <limits>    // for the range of T

namespace relevo
{
/// Returns a declared value in a floating point type: a declared -3.4e38 is the nearest float, and
/// values out of range are clamped, as GDAL does. Infinities and NaN are kept.
template <typename T>
T GetStoredNoData(double declared)
{
  const double largest = static_cast<double>(std::numeric_limits<T>::max());
  return static_cast<T>(
    std::isfinite(declared) ? std::clamp(declared, -largest, largest) : declared);
}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether a cell folds over itself, by the determinants of its derivatives
 *
 * Private to the module.
 */
#ifndef DeterminantSigns_h
#define DeterminantSigns_h

#include <algorithm>

namespace relevo
{
/// Returns whether the determinants of the derivatives in a cell have both signs, beyond rounding
/// errors. Such a cell folds over itself.
inline bool HasBothSigns(double lowest, double highest)
{
  constexpr double Rounding = 1e-9; // relative to the largest determinant
  return std::min(-lowest, highest) > Rounding * std::max(-lowest, highest);
}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   huge numbers that stand for missing values
 *
 * Scalars are scaled to their range and rounded to floats. A fill value such as 1e30 would make all
 * other values equal.
 *
 * Private to the modules.
 */
#ifndef FillValues_h
#define FillValues_h

#include "RelevoFiltersVolumeModule.h" // for export macro

#include <cstddef>
#include <functional>
#include <vector>

namespace relevo
{
/**
 * Returns the magnitudes of fill values, the largest one first. A fill value and its negative are
 * at least 1e15, and at least a million times all smaller magnitudes, which are not all 0.
 */
RELEVOFILTERSVOLUME_EXPORT std::vector<double> FindFillValues(
  size_t count, const std::function<double(size_t)>& get);

/// Returns whether a value is one of the fill values or not finite.
RELEVOFILTERSVOLUME_EXPORT bool IsMissing(double value, const std::vector<double>& fillValues);
}

#endif

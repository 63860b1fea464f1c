// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which vectors are data
 *
 * Private to the module's own sources.
 */
#ifndef vtkUsableVector_h
#define vtkUsableVector_h

#include <algorithm>
#include <cmath>

namespace relevo
{
/// Whether every component is a number below `noDataMagnitude` in absolute value.
inline bool IsUsableVector(const double vector[3], double noDataMagnitude)
{
  return std::all_of(vector, vector + 3,
    [=](double component) { return std::abs(component) < noDataMagnitude; }); // NaN is not
}
}

#endif

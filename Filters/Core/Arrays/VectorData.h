// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   distinguishes vectors from missing values
 */
#ifndef VectorData_h
#define VectorData_h

#include <algorithm>
#include <cmath>

namespace relevo
{
/// Whether all components are numbers below `noDataMagnitude` in absolute value.
inline bool IsVectorData(const double* vector, int components, double noDataMagnitude)
{
  return std::all_of(vector, vector + components,
    [=](double component) { return std::abs(component) < noDataMagnitude; }); // false for NaN
}
}

#endif

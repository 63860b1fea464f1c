// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which vectors are data, and which stand for none
 *
 * Private to the modules' own sources.
 */
#ifndef VectorData_h
#define VectorData_h

#include <algorithm>
#include <cmath>

namespace relevo
{
/// Whether every component is a number below `noDataMagnitude` in absolute value.
inline bool IsVectorData(const double* vector, int components, double noDataMagnitude)
{
  return std::all_of(vector, vector + components,
    [=](double component) { return std::abs(component) < noDataMagnitude; }); // NaN is not
}
}

#endif

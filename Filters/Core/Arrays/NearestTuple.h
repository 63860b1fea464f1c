// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   sets computed values in arrays of any type
 */
#ifndef NearestTuple_h
#define NearestTuple_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

class vtkDataArray;

namespace relevo
{
/// Whether the array has integers rather than floating-point numbers.
RELEVOFILTERSCORE_EXPORT bool HoldsIntegers(vtkDataArray* array);

/// Set a tuple to the nearest values of the array's type: see getNearestNumber(). Integers do not
/// change where a value is NaN.
RELEVOFILTERSCORE_EXPORT void SetNearestTuple(
  vtkDataArray* array, vtkIdType tuple, const double* values);
}

#endif

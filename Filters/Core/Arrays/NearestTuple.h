// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   computed values for arrays of any type
 *
 * Private to the modules' own sources.
 */
#ifndef NearestTuple_h
#define NearestTuple_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

class vtkDataArray;

namespace relevo
{
/// Rather than numbers with fractions.
RELEVOFILTERSCORE_EXPORT bool HoldsIntegers(vtkDataArray* array);

/// Sets a tuple as the array's type has it: see getNearestNumber(). Integers keep what they have
/// where a value is NaN.
RELEVOFILTERSCORE_EXPORT void SetNearestTuple(
  vtkDataArray* array, vtkIdType tuple, const double* values);
}

#endif

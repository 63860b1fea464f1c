// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   creates an output array like an input array
 */
#ifndef SimilarArray_h
#define SimilarArray_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace relevo
{
/**
 * Add an array to `to` with the type, name, components and attribute of `source` in `from`, and
 * with numberOfTuples tuples.
 */
RELEVOFILTERSCORE_EXPORT vtkAbstractArray* AddArrayLike(vtkDataSetAttributes* from,
  vtkAbstractArray* source, vtkDataSetAttributes* to, vtkIdType numberOfTuples);

/// Whether the array can be interpolated. Strings, bits and ghost flags cannot.
RELEVOFILTERSCORE_EXPORT bool IsInterpolated(vtkAbstractArray* array);
}

#endif

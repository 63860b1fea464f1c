// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   an array of a result that is like one of the input
 *
 * Private to the modules' own sources.
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
 * Add to `to` an array like `source` of `from` (type, name, components, part as attribute) with
 * room for numberOfTuples.
 */
RELEVOFILTERSCORE_EXPORT vtkAbstractArray* AddArrayLike(vtkDataSetAttributes* from,
  vtkAbstractArray* source, vtkDataSetAttributes* to, vtkIdType numberOfTuples);

/// Whether values between those of an array mean something: not for strings, bits and ghost flags.
RELEVOFILTERSCORE_EXPORT bool IsInterpolated(vtkAbstractArray* array);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   finds an array of cells where one of points is required, or vice versa
 */
#ifndef MisplacedArray_h
#define MisplacedArray_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <functional>
#include <string>

class vtkDataSet;

namespace relevo
{
/// Advice for the association that the array has: a sentence without its full stop, or "".
using ArrayAdvice = std::function<std::string(int association)>;

/// Advice to convert the array, for classes that use arrays of one association.
RELEVOFILTERSCORE_EXPORT std::string AdviseConversion(int association);
/// Advice to call SetInputArrayToProcess() with the other association.
RELEVOFILTERSCORE_EXPORT ArrayAdvice AdviseInputArray(const std::string& name);

/**
 * Return `no point array "NAME", but a cell array of that name. ADVICE` or, for
 * FIELD_ASSOCIATION_CELLS, the reverse. Returns an empty string if the data set has no array of
 * that name, or only one with the required association.
 */
RELEVOFILTERSCORE_EXPORT std::string DescribeMisplacedArray(vtkDataSet* data,
  const std::string& name, int association, const ArrayAdvice& advise = AdviseConversion);
}

#endif

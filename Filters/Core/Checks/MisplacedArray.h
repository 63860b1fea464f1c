// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   tells users that an array belongs to cells instead of points, or the other way round
 *
 * Private to the modules' own sources.
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

/// To convert the array, for classes that take arrays of one association.
RELEVOFILTERSCORE_EXPORT std::string AdviseConversion(int association);
/// To call SetInputArrayToProcess() with the other association.
RELEVOFILTERSCORE_EXPORT ArrayAdvice AdviseInputArray(const std::string& name);

/**
 * `no point array "NAME", but a cell array of that name. ADVICE` or, for FIELD_ASSOCIATION_CELLS,
 * the other way round; empty if the data set has no array of that name, or only one of the
 * association that is asked for.
 */
RELEVOFILTERSCORE_EXPORT std::string DescribeMisplacedArray(vtkDataSet* data,
  const std::string& name, int association, const ArrayAdvice& advise = AdviseConversion);
}

#endif

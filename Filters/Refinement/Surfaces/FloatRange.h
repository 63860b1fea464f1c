// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the range of numbers for which float computations do not overflow
 *
 * Both evaluators of a recipe use it and report the same errors.
 */
#ifndef FloatRange_h
#define FloatRange_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <string> // for sentences

class vtkDisplacement;
class vtkRefinementSurface;

namespace relevo
{
/// The largest coordinate relative to the middle of a mesh if faces are curved or displaced, and
/// the largest displacement.
constexpr double LargestLength = 1e30;

/**
 * Return which of the settings that are shader uniforms moves points too far, as a clause, or an
 * empty string. The height map must be up to date.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindRangeError(
  vtkRefinementSurface* surface, vtkDisplacement* displacement);
}

#endif

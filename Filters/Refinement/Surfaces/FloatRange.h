// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   how large numbers may be so that nothing computed from them in floats overflows
 *
 * Both evaluators of a recipe ask, and say the same.
 */
#ifndef FloatRange_h
#define FloatRange_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <string> // for sentences

class vtkDisplacement;
class vtkRefinementSurface;

namespace relevo
{
/// The largest coordinate relative to a mesh's middle where faces are curved or displaced, and the
/// largest displacement.
constexpr double LargestLength = 1e30;

/**
 * Which of their numbers that change live moves points too far, as a clause; empty for none.
 * Its height map must be up to date.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindRangeError(
  vtkRefinementSurface* surface, vtkDisplacement* displacement);
}

#endif

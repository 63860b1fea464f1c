// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   search for the nearest point of a patch
 *
 * Private to Relevo.
 */
#ifndef NearestPatchPoint_h
#define NearestPatchPoint_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersParametricModule.h" // for export macro

namespace relevo
{
class PatchArrays;

/**
 * Returns u and v of the point of a patch that is nearest to a position. Uses the Gauss-Newton
 * method, starting at the nearest point of a grid.
 */
RELEVOFILTERSPARAMETRIC_EXPORT vec2 FindNearestPatchPoint(
  const PatchArrays& patches, int patch, const dvec3& place);
}

#endif

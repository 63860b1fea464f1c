// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   where a patch is nearest to a place
 *
 * Private to Relevo's own sources.
 */
#ifndef NearestPatchPoint_h
#define NearestPatchPoint_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersParametricModule.h" // for export macro

namespace relevo
{
class PatchArrays;

/**
 * u and v of the patch's point that is nearest to a place: by the Gauss-Newton method from the
 * nearest of a grid of its points.
 */
RELEVOFILTERSPARAMETRIC_EXPORT vec2 FindNearestPatchPoint(
  const PatchArrays& patches, int patch, const dvec3& place);
}

#endif

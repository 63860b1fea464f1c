// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which points of a mesh lie at the same place
 *
 * Split normals and texture seams give one place several point ids. What must not open a crack
 * there (levels, displacement, curvature) is decided per place.
 */
#ifndef MergedPoints_h
#define MergedPoints_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

#include <cstdint> // for HashPoint()
#include <vector>  // for return value

class vtkPoints;

namespace relevo
{
/**
 * For every point the lowest id of a point with exactly the same coordinates (0 equals -0; a point
 * with a NaN is a place of its own). Empty when no two points coincide. Linear time, in parallel.
 */
RELEVOFILTERSCORE_EXPORT std::vector<vtkIdType> ComputeMergedPoints(vtkPoints* points);

/// A number that places have for themselves, as far as 64 bits go.
RELEVOFILTERSCORE_EXPORT std::uint64_t HashPoint(const double x[3]);

/**
 * Give every point the largest of the tags at its place. `places` as from ComputeMergedPoints();
 * `tags` has one finite value per point.
 */
RELEVOFILTERSCORE_EXPORT void UniteTags(const std::vector<vtkIdType>& mergedPoints, float* tags);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the coincident points of a mesh
 *
 * Split normals and texture seams cause several point ids at the same coordinates. Values that must
 * not open cracks there (levels, displacement, curvature) are computed per merged point.
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
 * Return for each point the lowest id of the points with exactly the same coordinates. 0 equals -0.
 * Points with NaN are never merged. The result is empty if no points coincide. Runs in linear time,
 * in parallel.
 */
RELEVOFILTERSCORE_EXPORT std::vector<vtkIdType> ComputeMergedPoints(vtkPoints* points);

/// A 64-bit hash of the coordinates, equal for coincident points.
RELEVOFILTERSCORE_EXPORT std::uint64_t HashPoint(const double x[3]);

/**
 * Set each tag to the largest tag of the coincident points. `mergedPoints` is the result of
 * ComputeMergedPoints(). `tags` has one finite value per point.
 */
RELEVOFILTERSCORE_EXPORT void UniteTags(const std::vector<vtkIdType>& mergedPoints, float* tags);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the initial positions of the points inside a graded pattern
 *
 * Where edges with different segments meet, the points are the tips of a fan of triangles at the
 * corner. Elsewhere, they are points of regular grids. The spacing of each grid follows a size
 * field that is computed from the border.
 */
#ifndef PatternInnerPoints_h
#define PatternInnerPoints_h

#include "Patterns/PatternPoint.h"

#include <vector>

namespace relevo
{
/**
 * Return the points inside a pattern with these segments, in descending order. `border` has the
 * points on its border.
 */
std::vector<PatternPoint> MakeInnerPoints(
  const int segments[3], const std::vector<PatternPoint>& border);
}

#endif

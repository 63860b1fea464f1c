// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where the points inside a graded pattern start
 *
 * At corners where edges of different segments meet, the tips of a fan of triangles; elsewhere the
 * points of regular grids, each grid where a size field that follows the border asks for its
 * spacing.
 *
 * Private to the module's own sources.
 */
#ifndef PatternInnerPoints_h
#define PatternInnerPoints_h

#include "Patterns/PatternPoint.h"

#include <vector>

namespace relevo
{
/**
 * Points inside a pattern with these segments, in descending order; `border` are the points on its
 * border.
 */
std::vector<PatternPoint> MakeInnerPoints(
  const int segments[3], const std::vector<PatternPoint>& border);
}

#endif

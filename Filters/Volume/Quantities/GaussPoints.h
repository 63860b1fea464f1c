// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the usual integration points of cells
 */
#ifndef GaussPoints_h
#define GaussPoints_h

#include "Cells/CellKind.h"

#include <array>
#include <vector>

namespace relevo
{
/**
 * Parametric coordinates of a number of integration points: Gauss-Legendre rules of 1 to 3 points
 * in each direction, the first one fastest, and rules of 1 and 3 points of triangles and of 1 and 4
 * points of tetrahedra, the k-th nearest to corner k. Wedges combine those of triangles and lines,
 * triangles fastest. Empty if there is no such rule.
 */
std::vector<std::array<double, 3>> FindGaussPoints(CellTopology shape, int number);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   generates the triangulation of a refinement pattern
 *
 * vtkRefinementPatternTable describes patterns. Equal numbers of segments give the regular
 * subdivision. All others are a Delaunay triangulation in the equilateral triangle, graded by a
 * size field that follows the segments of the border. Inner points are then moved to increase the
 * smallest angle around each.
 *
 * All decisions on topology use integer arithmetic, and other results are correctly rounded, so
 * that all machines generate the same patterns.
 *
 * @sa PatternMesh PatternVertexOrder
 */
#ifndef RefinementPatternGenerator_h
#define RefinementPatternGenerator_h

#include "Patterns/PatternBorder.h" // for MaximumNumberOfSegments
#include "Patterns/PatternCheck.h"  // for FindDefect
#include "Patterns/PatternMesh.h"   // for PatternMesh
#include "Patterns/PatternSides.h"  // for MakeLines
#include "Patterns/RefinementPattern.h"

namespace relevo
{
/**
 * Return the pattern with `n1 >= n2 >= n3` segments on edges 1, 2 and 3, each in
 * [1, MaximumNumberOfSegments].
 */
RefinementPattern GeneratePattern(int n1, int n2, int n3);

/**
 * Return the pattern for a mesh with these segments on its edges, in an order for drawing.
 */
RefinementPattern MakePattern(const int segments[3], PatternMesh mesh);
}

#endif

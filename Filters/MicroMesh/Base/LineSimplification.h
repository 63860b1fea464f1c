// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which vertices of lines a coarse mesh keeps
 *
 * Quadrics do not see how many segments a line needs. From its start, each segment of the coarse
 * line therefore goes to the farthest vertex for which it is within the tolerance.
 */
#ifndef LineSimplification_h
#define LineSimplification_h

#include <vector> // for the result

namespace relevo
{
class DenseMesh;

/// Per vertex, whether it is the end of a segment inside a line. All vertices of lines are within
/// the tolerance of the segments.
std::vector<char> FindLineVertices(const DenseMesh& mesh, double tolerance);
}

#endif

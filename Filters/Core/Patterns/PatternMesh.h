// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PatternMesh
 * @brief   a pattern in the making, in integers
 *
 * Private to the module's own sources.
 */
#ifndef PatternMesh_h
#define PatternMesh_h

#include "Patterns/PatternBorder.h"

#include <array>
#include <vector>

namespace relevo
{
struct PatternMesh
{
  /// In units of 1 / WeightScale, those of the border first.
  std::vector<PatternWeights> Vertices;
  std::vector<std::array<int, 3>> Triangles;
};

/**
 * The regular subdivision with n segments on each edge.
 */
PatternMesh MakeRegularMesh(int n);

/**
 * A Delaunay triangulation with these segments, not all the same, graded and smoothed.
 */
PatternMesh MakeGradedMesh(const int segments[3]);
}

#endif

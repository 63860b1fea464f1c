// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PatternMesh
 * @brief   a pattern under construction, in integers
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
  /// In units of 1 / WeightScale; border vertices come first.
  std::vector<PatternWeights> Vertices;
  std::vector<std::array<int, 3>> Triangles;
};

/**
 * Return the regular subdivision with n segments on each edge.
 */
PatternMesh MakeRegularMesh(int n);

/**
 * Return a graded and smoothed Delaunay triangulation with these segments, which must not be all
 * equal.
 */
PatternMesh MakeGradedMesh(const int segments[3]);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which faces of 3D cells are the same face, seen from the two cells that share it
 *
 * Private to the module's own sources.
 */
#ifndef FaceNeighbors_h
#define FaceNeighbors_h

#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>
#include <cstddef>
#include <vector>

namespace relevo
{
struct FaceMatch
{
  /// For each face the number of the one at the same corners; -1 at the border.
  std::vector<int> Others;
  /// Places where more than two faces have the same corners. These faces count as border.
  size_t NumberOfSharedByMore = 0;
};

/**
 * Faces by their corners: ids of points, less than numberOfPoints, in any order. Of a triangle the
 * last one is -1. A corner that repeats counts once, so that a quadrilateral may be a triangle;
 * what has less than three corners then matches nothing. Two faces of one cell match, too.
 */
RELEVOFILTERSVOLUME_EXPORT FaceMatch MatchFaces(
  const std::vector<std::array<int, 4>>& faces, int numberOfPoints);
}

#endif

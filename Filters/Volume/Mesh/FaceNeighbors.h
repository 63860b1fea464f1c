// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   matching of faces that two 3D cells share
 *
 * Private to the module.
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
  /// For each face the index of the face with the same corners; -1 on the border.
  std::vector<int> Others;
  /// Number of groups of more than two faces with the same corners. These faces are treated as
  /// border.
  size_t NumberOfSharedByMore = 0;
};

/**
 * Matches faces by their corners: point ids, less than numberOfPoints, in any order. The last
 * corner of a triangle is -1. Repeated corners are ignored, so that a quadrilateral can match a
 * triangle. Faces with less than three distinct corners match nothing. Two faces of the same cell
 * can match.
 */
RELEVOFILTERSVOLUME_EXPORT FaceMatch MatchFaces(
  const std::vector<std::array<int, 4>>& faces, int numberOfPoints);
}

#endif

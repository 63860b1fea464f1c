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
#include <functional>
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

/// Faces that are not stored.
struct FaceSource
{
  size_t NumberOfFaces;
  /// Writes the corners of the faces from begin to end. All corners of a missing face are -1.
  /// Several threads call this function.
  std::function<void(size_t begin, size_t end, std::array<int, 4>* faces)> Read;
};

/**
 * The same for faces that are not stored. `match` is called with each face and its match. Several
 * threads call it, for different faces. Returns the number of groups of more than two faces. Needs
 * memory for a fraction of the faces.
 */
RELEVOFILTERSVOLUME_EXPORT size_t MatchFaces(const FaceSource& source, int numberOfPoints,
  const std::function<void(size_t face, size_t other)>& match);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   quadrilaterals that the cells of both sides split differently
 *
 * The two sides use different diagonals, or only one side is split. MatchFaces() finds no match
 * then.
 *
 * Private to the module.
 */
#ifndef FaceSeams_h
#define FaceSeams_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>
#include <vector>

namespace relevo
{
struct FaceSeam
{
  /// In cyclic order.
  std::array<int, 4> Corners;
  /// The faces of each side: two triangles, or a quadrilateral and -1.
  std::array<std::array<int, 2>, 2> Faces;
};

/// Finds seams among the given faces, such as those without a match; see MatchFaces().
RELEVOFILTERSVOLUME_EXPORT std::vector<FaceSeam> FindSeams(const std::vector<dvec3>& points,
  const std::vector<std::array<int, 4>>& faces, const std::vector<int>& border);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   quadrilaterals of a mesh that the cells of both sides split differently
 *
 * By the other diagonal, or one side not at all: no face has the same corners as another.
 *
 * Private to the module's own sources.
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
  /// In turn.
  std::array<int, 4> Corners;
  /// Those of each side: two triangles, or a quadrilateral and -1.
  std::array<std::array<int, 2>, 2> Faces;
};

/// Seams among some of the faces, such as those at the border: see MatchFaces().
RELEVOFILTERSVOLUME_EXPORT std::vector<FaceSeam> FindSeams(const std::vector<dvec3>& points,
  const std::vector<std::array<int, 4>>& faces, const std::vector<int>& border);
}

#endif

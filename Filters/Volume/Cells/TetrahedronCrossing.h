// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where a ray is inside a tetrahedron
 *
 * Private to the module's own sources.
 */
#ifndef TetrahedronCrossing_h
#define TetrahedronCrossing_h

#include "Cells/CellShape.h"
#include "Cells/Ray.h"

#include <array>

namespace relevo
{
using TetrahedronCorners = std::array<dvec3, 4>;

/// Six times the volume, without a sign.
double ComputeSixfoldVolume(const TetrahedronCorners& corners);

/// The slopes, the same everywhere inside, and six times the volume: where that is 0, slopes are 0.
double ComputeSlopes(const TetrahedronCorners& corners, CornerSlopes& slopes);

struct TetrahedronCrossing
{
  /**
   * Cut the ray by the planes of the four faces. Corners may be in any order. What lies no farther
   * than `margin` outside of a face that is parallel to the ray counts as inside: a ray in a face
   * is inside both its cells.
   */
  bool Find(const TetrahedronCorners& corners, const Ray& ray, double margin);

  double Begin;
  double End;
  dvec4 FrontWeights; // of the corners
  dvec4 BackWeights;
};
}

#endif

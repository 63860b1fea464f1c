// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersection of a ray with a tetrahedron
 *
 * Private to the module.
 */
#ifndef TetrahedronCrossing_h
#define TetrahedronCrossing_h

#include "Cells/CellShape.h"
#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>

namespace relevo
{
using TetrahedronCorners = std::array<dvec3, 4>;

/// Returns six times the volume, without sign.
double ComputeSixfoldVolume(const TetrahedronCorners& corners);

/// Computes the constant slopes of a tetrahedron. Returns six times the volume. If that is 0,
/// slopes are 0.
RELEVOFILTERSVOLUME_EXPORT double ComputeSlopes(
  const TetrahedronCorners& corners, CornerSlopes& slopes);

struct TetrahedronCrossing
{
  /**
   * Clips the ray by the planes of the four faces. Corners can be in any order. A ray that is
   * parallel to a face and at most `margin` outside of it counts as inside, so that a ray in a face
   * is inside of both cells.
   */
  bool Find(const TetrahedronCorners& corners, const Ray& ray, double margin);

  double Begin;
  double End;
  dvec4 FrontWeights; // of the corners
  dvec4 BackWeights;
};
}

#endif

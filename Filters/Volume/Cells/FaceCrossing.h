// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where a ray goes through curved faces
 *
 * Hits are distances along the ray, in any order, and a place may come several times. All that
 * there are are found, but for rays that run in a face.
 *
 * Private to the module's own sources.
 */
#ifndef FaceCrossing_h
#define FaceCrossing_h

#include "Cells/Ray.h"

#include <array>
#include <vector>

namespace relevo
{
/// A bilinear face, by its corners in turn.
void CrossBilinearFace(
  const std::array<dvec3, 4>& corners, const Ray& ray, std::vector<double>& hits);

/// A quadratic triangle, by its corners and the middles of the edges after them.
void CrossQuadraticFace(
  const std::array<dvec3, 6>& points, const Ray& ray, std::vector<double>& hits);
}

#endif

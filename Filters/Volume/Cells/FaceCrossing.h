// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersection of rays with curved faces
 *
 * Hits are distances along the ray, in any order and possibly repeated. All hits are found unless
 * the ray lies in the face.
 *
 * Private to the module.
 */
#ifndef FaceCrossing_h
#define FaceCrossing_h

#include "Integral/Ray.h"

#include <array>
#include <vector>

namespace relevo
{
/// Intersects a bilinear face. Corners are in cyclic order.
void CrossBilinearFace(
  const std::array<dvec3, 4>& corners, const Ray& ray, std::vector<double>& hits);

/// Intersects a quadratic triangle. The points are its corners, followed by the midpoints of its
/// edges.
void CrossQuadraticFace(
  const std::array<dvec3, 6>& points, const Ray& ray, std::vector<double>& hits);
}

#endif

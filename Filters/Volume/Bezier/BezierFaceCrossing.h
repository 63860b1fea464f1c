// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersection of a ray with a face of a Bézier hexahedron
 *
 * Private to the module.
 */
#ifndef BezierFaceCrossing_h
#define BezierFaceCrossing_h

#include "Bezier/BezierHexahedron.h"
#include "Integral/Ray.h"

#include <vector>

namespace relevo
{
/**
 * Appends the distances of the hits along the ray. Face 2 d is at parameter d = 0, and face 2 d + 1
 * at 1. The face is halved until its Bézier points miss the ray, or until it is so flat that it has
 * at most one hit, which Newton's method finds.
 */
void CrossBezierFace(
  const BezierHexahedron& shape, int face, const Ray& ray, std::vector<double>& hits);
}

#endif

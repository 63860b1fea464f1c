// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   computes a cone that contains all normals of a Bezier triangle
 */
#ifndef BezierNormalCone_h
#define BezierNormalCone_h

#include "Mathematics/RefinementMathematics.h" // for vec3

#include <functional> // for control points

namespace relevo
{
/**
 * Implements vtkRefinementSurface::ComputeNormalCone(). The arguments of `controlPoint` are the
 * powers of the weights of corners 0, 1 and 2. Their sum is the degree.
 */
float ComputeBezierNormalCone(
  int degree, const std::function<vec3(int, int, int)>& controlPoint, float axis[3]);
}

#endif

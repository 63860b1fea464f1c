// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   a cone that holds all normals of a Bezier triangle
 */
#ifndef BezierNormalCone_h
#define BezierNormalCone_h

#include "Mathematics/RefinementMathematics.h" // for vec3

#include <functional> // for control points

namespace relevo
{
/**
 * For vtkRefinementSurface::ComputeNormalCone(). `controlPoint` takes the powers of the weights of
 * corners 0, 1 and 2, whose sum is the degree.
 */
float ComputeBezierNormalCone(
  int degree, const std::function<vec3(int, int, int)>& controlPoint, float axis[3]);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   functions of volume rendering that shaders and C++ share, in double precision
 *
 * Private to the module.
 */
#ifndef LinearSegment_h
#define LinearSegment_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

namespace relevo
{
using Real = double;
using Real2 = dvec2;
using Real3 = dvec3;
using Real4 = dvec4;

/**
 * Returns psi(a, b) = int_0^1 exp(-int_0^t (a (1 - u) + b u) du) dt, the mean transmittance from
 * points of a segment to its front. a and b are extinction * length at front and back, at least 0.
 * The relative error is below 1e-13.
 */
RELEVOFILTERSVOLUME_EXPORT double linearSegmentPsi(double front, double back);

#include "glsl/relevoLinearSegment.glsl"
#include "glsl/relevoVolumeShading.glsl"
}

#endif

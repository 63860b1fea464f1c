// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the LIC weights that shaders and C++ share
 *
 * Private to the module.
 */
#ifndef LICKernel_h
#define LICKernel_h

#include "Mathematics/RefinementMathematics.h"

#include <cmath>

namespace relevo
{
#include "glsl/relevoLICKernel.glsl"

/// Returns the fractional part of the phase, in [0, 1).
inline float licWrapPhase(double phase)
{
  const float wrapped = static_cast<float>(phase - std::floor(phase));
  return wrapped < 1.0f ? wrapped : 0.0f;
}
}

#endif

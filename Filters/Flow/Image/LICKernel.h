// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the shared weights of line integral convolution, in C++
 *
 * Private to the module's own sources.
 */
#ifndef LICKernel_h
#define LICKernel_h

#include "Mathematics/RefinementMathematics.h"

#include <cmath>

namespace relevo
{
#include "glsl/relevoLICKernel.glsl"

/// A phase from 0 to below 1.
inline float licWrapPhase(double phase)
{
  const float wrapped = static_cast<float>(phase - std::floor(phase));
  return wrapped < 1.0f ? wrapped : 0.0f;
}
}

#endif

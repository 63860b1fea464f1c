// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   computes levels from measured values, shared with shaders
 */
#ifndef LevelFunctions_h
#define LevelFunctions_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

#endif

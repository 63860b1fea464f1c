// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the stretch of contrast, shared with shaders
 */
#ifndef LICStretch_h
#define LICStretch_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoLICStretch.glsl"
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the contrast enhancement that shaders and C++ share
 */
#ifndef LICStretch_h
#define LICStretch_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoLICStretch.glsl"
}

#endif

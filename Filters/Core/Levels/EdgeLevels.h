// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   computes levels of edges from depth-tags, shared with shaders
 */
#ifndef EdgeLevels_h
#define EdgeLevels_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoLevels.glsl"
}

#endif

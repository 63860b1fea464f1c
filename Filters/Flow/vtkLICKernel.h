// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLICKernel
 * @brief   the shared weights of line integral convolution, in C++
 *
 * Private to the module's own sources.
 */
#ifndef vtkLICKernel_h
#define vtkLICKernel_h

#include "vtkRefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoLICKernel.glsl"
}

#endif

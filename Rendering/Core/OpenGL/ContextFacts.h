// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what is to be known of the context that is current
 *
 * Private to the modules.
 */
#ifndef ContextFacts_h
#define ContextFacts_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <string>

namespace relevo
{
/// OpenGL's name of what draws.
RELEVORENDERINGCORE_EXPORT std::string GetOpenGLRenderer();

/// Whether a GPU draws, rather than a program on the CPU.
RELEVORENDERINGCORE_EXPORT bool IsHardwareRenderer();

/// Whether shaders can read buffers by three floats: ARB_texture_buffer_object_rgb32, which is part
/// of OpenGL 4.0.
RELEVORENDERINGCORE_EXPORT bool HasBuffersOfThreeFloats();
}

#endif

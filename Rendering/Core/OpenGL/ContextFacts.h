// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   properties of the current OpenGL context
 *
 * Private to the modules.
 */
#ifndef ContextFacts_h
#define ContextFacts_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <string>

namespace relevo
{
/// Return the name of the OpenGL renderer.
RELEVORENDERINGCORE_EXPORT std::string GetOpenGLRenderer();

/// Return whether the renderer is a GPU, and not software on the CPU.
RELEVORENDERINGCORE_EXPORT bool IsHardwareRenderer();

/// Return whether shaders can read buffer textures with three floats per texel:
/// ARB_texture_buffer_object_rgb32, which is part of OpenGL 4.0.
RELEVORENDERINGCORE_EXPORT bool HasBuffersOfThreeFloats();
}

#endif

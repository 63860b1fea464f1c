// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   compiles and links shaders outside VTK's shader classes, and reports their errors
 */
#ifndef ShaderLog_h
#define ShaderLog_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <string> // for errors

namespace relevo
{
/**
 * Compile a shader of a stage (GL_VERTEX_SHADER, ...). If it does not compile, return 0 and set an
 * error that contains `name`.
 */
RELEVORENDERINGCORE_EXPORT unsigned int CompileShader(
  unsigned int stage, const char* name, const std::string& source, std::string& error);

/**
 * Link the shaders attached to a program. If they do not link, return false and set an error.
 */
RELEVORENDERINGCORE_EXPORT bool LinkProgram(
  unsigned int program, const char* name, std::string& error);
}

#endif

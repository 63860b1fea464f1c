// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   compiles and links shaders that VTK knows nothing of, and says what is wrong with them
 */
#ifndef ShaderLog_h
#define ShaderLog_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <string> // for errors

namespace relevo
{
/**
 * A compiled shader of a stage (GL_VERTEX_SHADER, ...); 0, with an error that names it by `name`,
 * when it does not compile.
 */
RELEVORENDERINGCORE_EXPORT unsigned int CompileShader(
  unsigned int stage, const char* name, const std::string& source, std::string& error);

/**
 * Link the shaders attached to a program. False, with an error, when they do not fit.
 */
RELEVORENDERINGCORE_EXPORT bool LinkProgram(
  unsigned int program, const char* name, std::string& error);
}

#endif

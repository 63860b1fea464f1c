// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   values that the vertex shader passes to the fragment shader
 *
 * Private to the modules.
 */
#ifndef ShaderVaryings_h
#define ShaderVaryings_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <string> // for members
#include <vector> // for signatures

namespace relevo
{
class ShaderText;

/// A value that the vertex shader passes to the fragment shader, through a geometry shader if there
/// is one. By VTK's convention its name is NameVSOutput, which VTK replaces by NameGSOutput after a
/// geometry shader.
struct ShaderVarying
{
  std::string Qualifier; // "flat " or nothing
  std::string Type;
  std::string Name;
};

/// Return declarations for a vertex shader ("out") or a fragment shader ("in").
RELEVORENDERINGCORE_EXPORT std::string DeclareVaryings(
  const char* direction, const std::vector<ShaderVarying>& varyings);

/// Make VTK's geometry shader pass the values on.
RELEVORENDERINGCORE_EXPORT void PassOnVaryings(
  const std::vector<ShaderVarying>& varyings, ShaderText& geometry);
}

#endif

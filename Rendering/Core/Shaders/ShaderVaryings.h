// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   values that go from the vertex shader to the fragments
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

/// A value that the vertex shader passes to the fragments, through a geometry shader if there is
/// one. VTK's naming: NameVSOutput, which it turns into NameGSOutput after a geometry shader.
struct ShaderVarying
{
  std::string Qualifier; // "flat " or nothing
  std::string Type;
  std::string Name;
};

/// Declarations of a vertex shader's ("out") or a fragment shader's ("in").
RELEVORENDERINGCORE_EXPORT std::string DeclareVaryings(
  const char* direction, const std::vector<ShaderVarying>& varyings);

/// Has VTK's geometry shader pass them on.
RELEVORENDERINGCORE_EXPORT void PassOnVaryings(
  const std::vector<ShaderVarying>& varyings, ShaderText& geometry);
}

#endif

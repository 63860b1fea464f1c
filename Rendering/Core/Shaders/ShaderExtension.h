// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the code that a subclass of a refining mapper adds to the vertex shader
 *
 * Private to the modules.
 */
#ifndef ShaderExtension_h
#define ShaderExtension_h

#include "Shaders/ShaderVaryings.h" // for members

#include <string> // for members
#include <vector> // for members

namespace relevo
{
/// The statements run when the vertex is complete: vertexMC, relevoNormal (unit length, or zero
/// without normals), relevoVertexWeights (of the sorted corners) and all attributes are set.
struct ShaderExtension
{
  /// Whether vertices have normals; the mapper sets it.
  bool HasNormals = false;

  std::vector<ShaderVarying> Varyings;
  std::string Declarations;
  std::string Statements;
  /// The key distinguishes the code that the subclass writes elsewhere in the shaders.
  std::string Key;
  /// Whether the subclass colours fragments, so that vertices need no colours of scalars.
  bool HasOwnColors = false;
};
}

#endif

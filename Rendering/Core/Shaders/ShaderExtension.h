// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a subclass of a refining mapper adds to its vertex shader
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
/// The statements run when the vertex is made: vertexMC, relevoNormal (unit, zero without normals),
/// relevoVertexWeights (of the sorted corners) and all attributes are set.
struct ShaderExtension
{
  /// From the mapper: whether vertices have normals.
  bool HasNormals = false;

  std::vector<ShaderVarying> Varyings;
  std::string Declarations;
  std::string Statements;
  /// Distinguishes what the subclass writes into other places of the shaders.
  std::string Key;
  /// Whether fragments have their colours from the subclass, so that vertices need none of scalars.
  bool HasOwnColors = false;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes VTK's shaders into shaders of reliefs
 *
 * Private to the module.
 */
#ifndef ReliefShader_h
#define ReliefShader_h

#include "Shaders/ShaderText.h"

#include <map>
#include <string>

namespace relevo
{
/// The options of shaders of reliefs.
struct ReliefShaderOptions
{
  /// The methods, numbered as in vtkReliefMapper.
  enum Methods
  {
    WARP,
    RAY_MARCH,
    REFINEMENT,
    NUMBER_OF_METHODS
  };
  Methods Method = RAY_MARCH;
  /// The searches of RAY_MARCH, numbered as in vtkReliefMapper.
  enum Searches
  {
    LINEAR_BINARY,
    LINEAR_SECANT,
    RELAXED_CONES,
    MAXIMUM_MIPMAP
  };
  int Search = MAXIMUM_MIPMAP;
  bool IsLit = false;
  bool IsShadowed = false; // shadows on itself from the first light
  bool Yields = false;     // hidden by other reliefs of the same surface
  bool IsRim = false;      // behind all reliefs
  bool HasNormals = false;
  int NumberOfPlanes = 0; // planes that clip rays
  /// The ids that a selection draws.
  enum Ids
  {
    NO_IDS,
    POINT_IDS,
    CELL_IDS
  };
  Ids Selected = NO_IDS;

  std::string GetKey() const;
};

/// Change the templates before VTK does.
void PrepareReliefShaders(const ReliefShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Change the shaders after VTK.
void FinishReliefShaders(const ReliefShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

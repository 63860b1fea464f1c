// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how VTK's shaders become those of a relief
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
/// What shaders of reliefs differ in.
struct ReliefShaderOptions
{
  /// Numbered as vtkReliefMapper does.
  enum Methods
  {
    WARP,
    RAY_MARCH,
    REFINEMENT,
    NUMBER_OF_METHODS
  };
  Methods Method = RAY_MARCH;
  /// Of RAY_MARCH, numbered likewise.
  enum Searches
  {
    LINEAR_BINARY,
    LINEAR_SECANT,
    RELAXED_CONES,
    MAXIMUM_MIPMAP
  };
  int Search = MAXIMUM_MIPMAP;
  bool IsLit = false;
  bool IsShadowed = false; // by itself, from the first lamp
  bool Yields = false;     // to other reliefs of the same surface
  bool IsRim = false;      // behind all of them
  bool HasNormals = false;
  int NumberOfPlanes = 0; // that cut rays off
  /// What ids are drawn for a selection.
  enum Ids
  {
    NO_IDS,
    POINT_IDS,
    CELL_IDS
  };
  Ids Selected = NO_IDS;

  std::string GetKey() const;
};

/// Before VTK puts its text into the templates.
void PrepareReliefShaders(const ReliefShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Afterwards.
void FinishReliefShaders(const ReliefShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

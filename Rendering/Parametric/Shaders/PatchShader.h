// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes the shaders of a refined surface to evaluate patches at every pixel
 *
 * Private to the module.
 */
#ifndef PatchShader_h
#define PatchShader_h

#include "Buffers/FieldColoring.h"
#include "Shaders/ShaderText.h"

#include <map>

namespace relevo
{
struct ShaderExtension;

/// The options of the shaders.
struct PatchShaderOptions
{
  FieldColoring Coloring = FieldColoring::NONE;
  bool IsRational = false;  // whether weights of control points differ
  bool IsNumber = false;    // whether each control point has a single coefficient
  bool HasIsolines = false; // false for COLORS
  bool HasEdges = false;

  bool HasColors() const { return this->Coloring != FieldColoring::NONE; }
  bool HasLines() const { return this->HasIsolines || this->HasEdges; }
  bool IsEmpty() const { return !this->HasColors() && !this->HasEdges; }
};

/// Make vertices pass their patch and the coordinates on it.
void ExtendPatchShaders(const PatchShaderOptions& options, ShaderExtension& extension);

/// Change the templates before VTK does. `ownFragments`: see HasOwnFragments().
void PreparePatchShaders(const PatchShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Change the shaders after VTK.
void FinishPatchShaders(const PatchShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

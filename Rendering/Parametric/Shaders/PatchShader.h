// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how the shaders of a refined surface show fields and lines of patches at every pixel
 *
 * Private to the module.
 */
#ifndef PatchShader_h
#define PatchShader_h

#include "Shaders/ShaderText.h"

#include <map>

namespace relevo
{
struct ShaderExtension;

/// How coefficients become colours.
enum class PatchColoring
{
  NONE,    // there are none
  TABLE,   // the number is looked up
  TEXTURE, // VTK's texture of the table has them
  COLORS   // they are colours
};

/// What fragments show of patches.
struct PatchShaderOptions
{
  PatchColoring Coloring = PatchColoring::NONE;
  bool HasIsolines = false; // not of COLORS
  bool HasEdges = false;

  bool HasColors() const { return this->Coloring != PatchColoring::NONE; }
  bool HasLines() const { return this->HasIsolines || this->HasEdges; }
  bool IsEmpty() const { return !this->HasColors() && !this->HasEdges; }
};

/// Has vertices give fragments their patch, and where on it they are.
void ExtendPatchShaders(const PatchShaderOptions& options, ShaderExtension& extension);

/// Before VTK puts its text into the templates. `ownFragments`: see HasOwnFragments().
void PreparePatchShaders(const PatchShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Afterwards.
void FinishPatchShaders(const PatchShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

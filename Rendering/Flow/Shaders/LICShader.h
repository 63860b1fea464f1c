// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes the shaders of a refined surface to draw its vectors, or to show their LIC
 *
 * Private to the module's own sources.
 */
#ifndef LICShader_h
#define LICShader_h

#include "Shaders/ShaderText.h"

#include <map>

namespace relevo
{
struct ShaderExtension;

struct LICShaderOptions
{
  enum Purposes
  {
    NONE,
    VECTORS, // draw the surface's vectors into an image
    IMAGE    // show their LIC on the surface
  };
  Purposes Purpose = NONE;
  bool StretchesColors = false;
  bool AreOfCells = false;      // whether vectors are of cells
  bool HasNormals = false;      // whether the refined surface or its points have normals
  bool HasPointNormals = false; // whether its points have normals
};

/// Make vertices pass the values that fragments need.
void ExtendLICShaders(const LICShaderOptions& options, ShaderExtension& extension);

/// Change the templates before VTK does.
void PrepareLICShaders(const LICShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Change the shaders after VTK. `needsEdges` means that VTK must have written edges, which are
/// drawn over streaks.
void FinishLICShaders(const LICShaderOptions& options, bool needsEdges,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how the shaders of a refined surface draw its vectors, and show their LIC
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
    VECTORS, // the surface's vectors become an image
    IMAGE    // the surface shows their LIC
  };
  Purposes Purpose = NONE;
  bool StretchesColors = false;
  bool AreOfCells = false;      // the vectors
  bool HasNormals = false;      // the refined surface, or its points
  bool HasPointNormals = false; // its points
};

/// Has vertices give fragments what they need.
void ExtendLICShaders(const LICShaderOptions& options, ShaderExtension& extension);

/// Before VTK puts its text into the templates.
void PrepareLICShaders(const LICShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Afterwards. `needsEdges`: VTK is to have written edges, which are drawn over streaks.
void FinishLICShaders(const LICShaderOptions& options, bool needsEdges,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

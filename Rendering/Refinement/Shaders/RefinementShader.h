// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes the shaders of VTK's polydata mapper into refining shaders
 *
 * VTK's vertex shader uses attributes (vertexMC, normalMC, scalarColor, ...). Here they become
 * globals, which are computed at the start of main() from the pattern vertex and the coarse face.
 * VTK's code for lighting, colours, clipping, peeling and picking then works unchanged. Private to
 * the module.
 */
#ifndef RefinementShader_h
#define RefinementShader_h

#include <map>    // for signature
#include <string> // for members
#include <vector> // for members

#include "Shaders/RefinementShaderOptions.h"
#include "Shaders/ShaderText.h" // for MissingAnchors
#include "vtkShader.h"          // for vtkShader::Type

namespace relevo
{
/// The purpose of VTK's shaders.
struct ShaderPurpose
{
  bool HasLines = false;        // to draw a wireframe
  bool HasEdges = false;        // VTK's geometry shader shows the edges of faces
  bool HasPointIds = false;     // a selection asks for points
  bool HasCellIds = false;      // a selection asks for cells
  bool HasOwnFragments = false; // the actor's own source may have replaced VTK's code for fragments
};

/**
 * Change VTK's finished shaders. Return the names of the vertex attributes that the vertex shader
 * now reads from the samplers GetAttributeSampler(name).
 */
std::vector<std::string> RefineShaders(const RefinementShaderOptions& options,
  const ShaderPurpose& purpose, std::map<vtkShader::Type, vtkShader*>& shaders,
  MissingAnchors& missing);

/**
 * Insert an anchor for the colours of faces, before VTK writes its own.
 */
void MarkColors(const RefinementShaderOptions& options, const ShaderPurpose& purpose,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

std::string GetAttributeSampler(const std::string& attribute);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementShader
 * @brief   turns the shaders of VTK's polydata mapper into refining ones
 *
 * VTK writes its vertex shader in terms of attributes (vertexMC, normalMC, scalarColor, ...). Here
 * they become plain globals, set at the start of main() from the pattern vertex and the coarse
 * face; VTK's lighting, colouring, clipping, peeling and picking code then works unchanged.
 * Private to the module.
 */
#ifndef RefinementShader_h
#define RefinementShader_h

#include <map>    // for signature
#include <string> // for members
#include <vector> // for members

#include "Shaders/RefinementShaderOptions.h"
#include "vtkShader.h" // for vtkShader::Type

namespace relevo
{
/**
 * Rewrite finished shaders of VTK's; `lines` for those that draw a wireframe. Returns the names of
 * the vertex attributes that the vertex shader now reads from the samplers
 * GetAttributeSampler(name).
 */
std::vector<std::string> RefineShaders(const RefinementShaderOptions& options, bool lines,
  std::map<vtkShader::Type, vtkShader*>& shaders);

/**
 * Keep a place for the colours of faces, before VTK writes its own.
 */
void MarkColors(std::map<vtkShader::Type, vtkShader*>& shaders);

std::string GetAttributeSampler(const std::string& attribute);
}

#endif

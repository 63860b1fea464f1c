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

#include "Buffers/RefinementColors.h"     // for KindType
#include "Buffers/RefinementLevelTable.h" // for RefinementColorMode
#include "vtkShader.h"                    // for vtkShader::Type

namespace relevo
{
/// A value handed from the vertex shader to the fragments, through a geometry shader if there is
/// one. VTK's naming: NameVSOutput, which it turns into NameGSOutput behind a geometry shader.
struct ShaderVarying
{
  std::string Qualifier; // "flat " or nothing
  std::string Type;
  std::string Name;
};

/// What a subclass of the mapper adds to the vertex shader. Its statements run when the vertex is
/// made: vertexMC, relevoNormal (unit, zero without normals) and all attributes are set.
struct ShaderExtension
{
  std::vector<ShaderVarying> Varyings;
  std::string Declarations;
  std::string Statements;
};

/// What the shaders depend on.
struct RefinementShaderOptions
{
  /// How a vertex comes to its face, see relevoFaceVS.glsl; from the method.
  std::string PlacementSource;
  /// The surface's functions; see vtkRefinementSurface::GetShaderSource().
  std::string SurfaceSource;
  int VectorsPerEdge = 0;
  int VectorsPerFace = 0;
  /// Texels per point, and which of them hold its direction and its values.
  int PointStride = 1;
  int PointDirection = 1;
  int PointValues = 1;
  bool HasNormals = false;
  bool HasDisplacement = false;
  bool AlongNormal = false;
  bool HasDirections = false;
  bool HasSeams = false;
  bool HasHoles = false;
  /// Whether vertices slide with the tags of the edges.
  bool IsMorphing = false;
  /// Whether draws are indirect, and each instance brings its faces along.
  bool IsIndirect = false;
  /// How points between the coarse ones come to the colours of scalars.
  RefinementColors::KindType Scalars = RefinementColors::BY_VTK;
  /// Whether some scalars stand for no data.
  bool HasNoData = false;
  /// What faces are coloured by.
  RefinementColorMode ColorMode = vtkAdaptiveRefinementMapper::COLOR_BY_SCALARS;
  ShaderExtension Extension;

  /// Everything above in one line, to compare.
  std::string GetKey() const;
};

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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes VTK's shaders into shaders of terrains
 *
 * Private to the module.
 */
#ifndef TerrainShader_h
#define TerrainShader_h

#include "Changes/Dependencies.h"
#include "Shaders/ShaderText.h"

#include <map>
#include <string>

namespace relevo
{
/// The colours of a terrain.
enum class TerrainColoring
{
  SOLID, // the actor's
  ELEVATION,
  SLOPE,
  ASPECT,
  HILLSHADE,
  IMAGERY,
  RASTER // numbers of another raster
};

/// Return whether a lookup table maps numbers to colours.
bool HasTable(TerrainColoring coloring);
/// Return whether fragments need heights from tiles.
bool HasHeights(TerrainColoring coloring, bool hasContours);
/// Return whether the colours need tiles of imagery.
bool HasImagery(TerrainColoring coloring);

/// Return whether the colours need the gradient at each fragment.
bool HasGradients(TerrainColoring coloring);

/// The part of a terrain that a shader program draws.
enum class TerrainPart
{
  SURFACE,
  BOTTOM, // of a solid
  BORDER  // the faces at the borders of a solid, with their walls and their bottom
};

/// The options of shaders of terrains.
struct TerrainShaderOptions
{
  TerrainColoring Coloring = TerrainColoring::SOLID;
  bool HasContours = false;
  bool HasCells = false; // for a selection of cells
  bool IsGlobe = false;  // the geocentric frame
  TerrainPart Part = TerrainPart::SURFACE;
  /// Whether vertices have normals, for small triangles, instead of fragments. Not on a globe, nor
  /// if the colours are those of slopes. For surfaces only.
  bool HasVertexNormals = false;

  Dependencies GetKey() const;
};

/// Change the templates before VTK does. `ownFragments`: see HasOwnFragments().
void PrepareTerrainShaders(const TerrainShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Change the shaders after VTK.
void FinishTerrainShaders(const TerrainShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the options of a refining mapper's shaders
 *
 * Private to the module.
 */
#ifndef RefinementShaderOptions_h
#define RefinementShaderOptions_h

#include "Buffers/FieldColoring.h"   // for member
#include "Buffers/VertexColors.h"    // for ScalarKind
#include "Changes/Dependencies.h"    // for GetKey
#include "Shaders/ShaderExtension.h" // for members

#include <string> // for members

namespace relevo
{
/// The values that colour faces, as in vtkAdaptiveRefinementMapper::RefinementColorModes.
enum RefinementColorMode
{
  COLOR_BY_SCALARS = 0,
  COLOR_BY_LEVEL = 1,
  COLOR_BY_PATTERN = 2,
  COLOR_BY_METRIC = 3
};

/// The options that the shaders depend on.
struct RefinementShaderOptions
{
  /// How a vertex is assigned to its face, see relevoFaceVS.glsl. The method sets it.
  std::string PlacementSource;
  /// The surface's functions; see vtkRefinementSurface::GetShaderSource().
  std::string SurfaceSource;
  int VectorsPerEdge = 0;
  int VectorsPerFace = 0;
  /// Texels per point, and the texels of its direction and its values.
  int PointStride = 1;
  int PointDirection = 1;
  int PointValues = 1;
  bool HasNormals = false;
  bool HasDisplacement = false;
  bool AlongNormal = false;
  bool HasDirections = false;
  /// Properties of the surface.
  bool HasSurfaceDirections = false;
  bool HasTables = false;
  bool HasSeams = false;
  bool HasHoles = false;
  /// Whether vertices morph with the tags of the edges.
  bool IsMorphing = false;
  /// Whether draws are indirect, with the faces of each instance in the buffer.
  bool IsIndirect = false;
  ScalarKind Scalars = BY_VTK;
  FieldColoring Field = FieldColoring::NONE;
  /// The surface's functions; see SurfaceFieldShading.
  std::string FieldSource;
  /// Whether some scalars are no data.
  bool HasNoData = false;
  /// The values that colour faces, a RefinementColorMode.
  int ColorMode = COLOR_BY_SCALARS;
  ShaderExtension Extension;

  /// Return a key of all options, for comparison.
  Dependencies GetKey() const;
};
}

#endif

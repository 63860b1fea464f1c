// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the shaders of a refining mapper depend on
 *
 * Private to the module.
 */
#ifndef RefinementShaderOptions_h
#define RefinementShaderOptions_h

#include "Buffers/VertexColors.h"    // for ScalarKind
#include "Changes/Dependencies.h"    // for GetKey
#include "Shaders/ShaderExtension.h" // for members

#include <string> // for members

namespace relevo
{
/// What faces are coloured by; the numbers of vtkAdaptiveRefinementMapper::RefinementColorModes.
enum RefinementColorMode
{
  COLOR_BY_SCALARS = 0,
  COLOR_BY_LEVEL = 1,
  COLOR_BY_PATTERN = 2,
  COLOR_BY_METRIC = 3
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
  /// What the surface has.
  bool HasSurfaceDirections = false;
  bool HasTables = false;
  bool HasSeams = false;
  bool HasHoles = false;
  /// Whether vertices slide with the tags of the edges.
  bool IsMorphing = false;
  /// Whether draws are indirect, and each instance brings its faces along.
  bool IsIndirect = false;
  ScalarKind Scalars = BY_VTK;
  /// Whether some scalars stand for no data.
  bool HasNoData = false;
  /// What faces are coloured by, a RefinementColorMode.
  int ColorMode = COLOR_BY_SCALARS;
  ShaderExtension Extension;

  /// Everything above, to compare.
  Dependencies GetKey() const;
};
}

#endif

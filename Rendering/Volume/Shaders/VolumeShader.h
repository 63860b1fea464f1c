// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the source of the shaders
 *
 * Private to the module.
 */
#ifndef VolumeShader_h
#define VolumeShader_h

#include "Segments/SegmentFormat.h"

#include <string>

namespace relevo
{
/// The output of the ray casting shader.
enum class SegmentOutput
{
  None,   // the colour of the ray
  Buffer, // its segments, see relevoVolumeSegments.glsl
  Pass    // one of its segments
};

struct VolumeShaderOptions
{
  BlendMode Blending = BlendMode::Composite;
  int NumberOfComponents = 1;
  int NumberOfCurves = 1;
  bool AreDependent = false;
  bool HasCellScalars = false;
  int FirstComponent = 0; // index of the curves' first component
  bool HasTables = false; // for 2D functions
  bool HasGradientOpacity = false;
  bool HasSurfaces = false;
  bool IsClipped = false;
  /// The number of components with lit colours; 0 without shading.
  int NumberOfMaterials = 0;
  int FirstMaterial = 0; // its component
  int NumberOfLights = 0;
  /// The dimensions of the pre-integration table; 0 for none.
  int PreIntegrated = 0;
  bool HasTetrahedra = true;
  bool HasCurvedCells = false;
  bool HasQuadraticCells = false;
  bool HasPyramids = false;
  bool HasFoldedFaces = false;   // some faces are front and back faces at once
  bool IsDiscontinuous = false;  // points have different scalars at the same place
  bool HasCornerScalars = false; // corners of tetrahedra have different scalars at the same place
  bool HasHangingFaces = false;  // several cells are behind some faces
  /// Whether rays start at active cells instead of the border, and end behind them.
  bool HasActiveCells = false;
  /// Whether rays start at the first visible cell, and end behind the last one.
  bool HasVisibleCells = false;
  /// Whether the near plane may clip projected cells.
  bool IsCutByNear = false;
  SegmentOutput Segments = SegmentOutput::None;
};

/// Return the format of the segments.
SegmentFormat GetSegmentFormat(const VolumeShaderOptions& options);

//@{
/// Return the shaders of the pass that finds where rays enter.
std::string MakeEntriesVertexShader(const VolumeShaderOptions& options);
std::string MakeEntriesShader(const VolumeShaderOptions& options);
/// Return the shader that finds the entries by a search, over the viewport.
std::string MakeCountShader(const VolumeShaderOptions& options);
//@}

//@{
/// Return the shaders that find the ranges of cells, mark the faces of active cells, and find the
/// outlines of these faces.
std::string MakeRangesShader(const VolumeShaderOptions& options);
std::string MakeActiveShader(const VolumeShaderOptions& options);
std::string MakeOutlinesShader(const VolumeShaderOptions& options);
//@}

//@{
/// Return the shaders that draw these faces to find where rays enter the first visible cell, and
/// which depth is behind the last one.
std::string MakeVisibleVertexShader(const VolumeShaderOptions& options);
std::string MakeFirstShader(const VolumeShaderOptions& options);
std::string MakeLastShader();
//@}

//@{
/// Return the shaders that draw the nearest isosurface from these faces.
std::string MakeNearestVertexShader(const VolumeShaderOptions& options);
std::string MakeNearestShader(const VolumeShaderOptions& options);
//@}

/// Return the shader of the ray caster, with VTK's anchors for render passes.
std::string MakeRayCastShader(const VolumeShaderOptions& options);

//@{
/// Return the shaders of cell projection: for the depth limits of rays, for the cells, and for
/// drawing their image to the window or converting stored data to an image.
std::string MakeLimitsShader(const VolumeShaderOptions& options);
std::string MakeProjectionVertexShader(const VolumeShaderOptions& options);
std::string MakeProjectionShader(const VolumeShaderOptions& options);
std::string MakeProjectedShader();
bool IsStored(const VolumeShaderOptions& options);
std::string MakeFinishShader(const VolumeShaderOptions& options);
//@}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the text of the shaders
 *
 * Private to the module.
 */
#ifndef VolumeShader_h
#define VolumeShader_h

#include "Rays/BlendMode.h"

#include <string>

namespace relevo
{
struct VolumeShaderOptions
{
  BlendMode Blending = BlendMode::Composite;
  int NumberOfComponents = 1;
  int NumberOfCurves = 1;
  bool AreDependent = false;
  bool HasCellScalars = false;
  int FirstComponent = 0; // of the curves
  bool HasTables = false; // 2D functions
  bool HasGradientOpacity = false;
  bool HasSurfaces = false;
  bool IsClipped = false;
  /// Components whose colours are lit; 0 without shading.
  int NumberOfMaterials = 0;
  int FirstMaterial = 0; // its component
  int NumberOfLights = 0;
  /// Dimensions of the table of pre-integration; 0 for none.
  int PreIntegrated = 0;
  bool HasTetrahedra = true;
  bool HasCurvedCells = false;
  bool HasQuadraticCells = false;
  bool HasPyramids = false;
  bool HasFoldedFaces = false; // from some directions
  /// Of cell projection: whether the near plane may cut cells.
  bool IsCutByNear = false;
};

//@{
/// Of the pass that tells where rays enter.
std::string MakeEntriesVertexShader(const VolumeShaderOptions& options);
std::string MakeEntriesShader(const VolumeShaderOptions& options);
/// The same by looking for them, over the viewport.
std::string MakeCountShader(const VolumeShaderOptions& options);
//@}

/// Of the ray caster, with VTK's anchors for render passes in it.
std::string MakeRayCastShader(const VolumeShaderOptions& options);

//@{
/// Of cell projection: first of what cells ask of rays, then of them, last of what puts their
/// picture into the window, or makes one of what they have stored in its place.
std::string MakeLimitsShader(const VolumeShaderOptions& options);
std::string MakeProjectionVertexShader(const VolumeShaderOptions& options);
std::string MakeProjectionShader(const VolumeShaderOptions& options);
std::string MakeProjectedShader();
bool IsStored(const VolumeShaderOptions& options);
std::string MakeFinishShader(const VolumeShaderOptions& options);
//@}
}

#endif

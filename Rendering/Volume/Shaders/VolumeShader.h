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

#include <string>

namespace relevo
{
struct VolumeShaderOptions
{
  int NumberOfComponents = 1;
  int NumberOfCurves = 1;
  bool AreDependent = false;
  bool HasCellScalars = false;
  /// Dimensions of the table of pre-integration; 0 for none.
  int PreIntegrated = 0;
};

/// Of the pass that tells where rays enter.
std::string MakeEntriesShader();

/// Of the ray caster, with VTK's anchors for render passes in it.
std::string MakeRayCastShader(const VolumeShaderOptions& options);

//@{
/// Of cell projection, and of what puts its picture into the window.
std::string MakeProjectionVertexShader(const VolumeShaderOptions& options);
std::string MakeProjectionShader(const VolumeShaderOptions& options);
std::string MakeProjectedShader();
//@}
}

#endif

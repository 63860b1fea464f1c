// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  VolumeFrame
 * @brief   the input of the stages that draw
 *
 * Private to the module.
 */
#ifndef VolumeFrame_h
#define VolumeFrame_h

#include "View/RayView.h"
#include "View/RenderPasses.h"

#include <array>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace relevo
{
class IntegralTable;
class OpaqueDepth;
class RenderTarget;
class ScreenPass;
class VolumePrograms;
struct VolumeFeatures;
struct VolumeFunctions;
struct VolumeMesh;

struct VolumeFrame
{
  vtkOpenGLRenderWindow* Window;
  std::array<int, 4> Viewport; // lower left corner and size
  RayView View;
  RenderPasses Passes;
  const VolumeFeatures& Features;
  VolumeMesh& Mesh;
  VolumeFunctions& Functions;
  IntegralTable& Table;
  VolumePrograms& Programs;
  OpaqueDepth& Depth;
  RenderTarget& Target; // replaces the window's framebuffer
  ScreenPass& Screen;

  /// Return the view of the mesh from another viewport.
  RayView GetView(const std::array<int, 4>& viewport) const;

  /// Return the error if the target cannot have this size.
  static std::string DescribeTooLarge(const std::array<int, 2>& size);

  //@{
  /// Bind all data of the volume to the current program.
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;
  //@}
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  VolumeFrame
 * @brief   what the stages that draw get
 *
 * Private to the module.
 */
#ifndef VolumeFrame_h
#define VolumeFrame_h

#include "View/RayView.h"
#include "View/RenderPasses.h"

#include <array>

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
  RenderTarget& Target; // to draw to instead of the window
  ScreenPass& Screen;

  /// How the pixels of another viewport see the mesh.
  RayView GetView(const std::array<int, 4>& viewport) const;

  //@{
  /// Have a program read all data of the volume; it is in use.
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;
  //@}
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Compositor
 * @brief   the stage that reads the frame's depths, chooses the pixels and adds the picture
 *
 * Private to the module.
 */
#ifndef Compositor_h
#define Compositor_h

#include "Passes/ScreenPass.h"
#include "Shaders/VolumePrograms.h"
#include "Targets/RenderTarget.h"
#include "View/OpaqueDepth.h"

#include <array>
#include <string>

class vtkWindow;

namespace relevo
{
struct VolumeFrame;

struct SamplingRequest
{
  double Distance;      // a ray each so many pixels,
  bool IsAutomatic;     // or as many as
  double AllocatedTime; // this allows, in seconds
};

class Compositor
{
public:
  /// Copy the depths of opaque props in the viewport. Returns what is wrong, or "".
  std::string ReadDepths(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport);

  /// How many pixels rays are cast for.
  std::array<int, 2> ChooseSize(const std::array<int, 4>& viewport, const SamplingRequest& request);

  /// The seconds that the frame took, for the next one's size.
  void SetTime(double seconds);

  /// Add what has been drawn to the target to the window, by a program that reads it. Returns what
  /// is wrong, or "".
  std::string Add(const VolumeFrame& frame, VolumeShader shader);

  OpaqueDepth& GetDepth() { return this->Depth; }
  RenderTarget& GetTarget() { return this->Target; }
  ScreenPass& GetScreen() { return this->Screen; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  OpaqueDepth Depth;
  RenderTarget Target;
  ScreenPass Screen;
  double SampleDistance = 1.0; // in use
  double WholeTime = 0.0;      // seconds that a ray for each pixel takes
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Compositor
 * @brief   the stage that reads the depths, chooses the resolution and composites the image
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
#include <vector>

class vtkWindow;

namespace relevo
{
struct VolumeFrame;

struct SamplingRequest
{
  double Distance;      // distance of rays in pixels
  bool IsAutomatic;     // whether the distance may be larger, so that the frame fits into
  double AllocatedTime; // the allotted time in seconds
};

class Compositor
{
public:
  /// Copy the depths of opaque props in the viewport. Return the error, or "".
  std::string ReadDepths(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport);

  /// Use these depths in the viewport instead. Rays begin at `begins`, unless it is empty. Return
  /// the error, or "".
  std::string SetDepths(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport,
    const std::vector<float>& depths, const std::vector<float>& begins);

  /// Return the number of rays per row and column.
  std::array<int, 2> ChooseSize(const std::array<int, 4>& viewport, const SamplingRequest& request);

  /// Set the seconds that the frame took, which determine the next resolution.
  void SetTime(double seconds);

  /// Composite the target's content onto the window, with a program that reads it. Return the
  /// error, or "".
  std::string Add(const VolumeFrame& frame, VolumeShader shader);

  OpaqueDepth& GetDepth() { return this->Depth; }
  RenderTarget& GetTarget() { return this->Target; }
  ScreenPass& GetScreen() { return this->Screen; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  OpaqueDepth Depth;
  RenderTarget Target;
  ScreenPass Screen;
  double SampleDistance = 1.0; // in use, in pixels
  double WholeTime = 0.0;      // seconds for one ray per pixel
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayCaster
 * @brief   the stage that casts a ray for each pixel
 *
 * Private to the module.
 */
#ifndef RayCaster_h
#define RayCaster_h

#include "View/RayEntries.h"

#include <array>
#include <string>

class vtkWindow;

namespace relevo
{
struct VolumeFrame;

class RayCaster
{
public:
  /// Draw over the window's viewport, or, if another number of pixels is to be sampled, to the
  /// frame's target. Returns what is wrong, or "".
  std::string Draw(const VolumeFrame& frame, const std::array<int, 2>& size);

  /// The most border faces that a pixel's ray enters through; draws them, and waits for the GPU.
  int CountLayers(const VolumeFrame& frame);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool RenderRayEntries(const VolumeFrame& frame, const std::array<int, 2>& size);
  vtkShaderProgram* Ready(const VolumeFrame& frame, const std::array<int, 4>& viewport);

  RayEntries Entries;
};
}

#endif

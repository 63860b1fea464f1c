// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayCaster
 * @brief   the stage that casts rays
 *
 * Private to the module.
 */
#ifndef RayCaster_h
#define RayCaster_h

#include "Changes/Dependencies.h"
#include "View/RayEntries.h"

#include <array>
#include <string>

class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class VisibleCells;
struct VolumeFrame;

class RayCaster
{
public:
  /// Draw over the window's viewport or, with another number of rays, to the frame's target. If
  /// visible cells are ready, rays walk only between the first and the last of them. Return the
  /// error, or "".
  std::string Draw(
    const VolumeFrame& frame, const std::array<int, 2>& size, VisibleCells* visible = nullptr);

  //@{
  /// Make the program of rays current, with all its data, for another viewport. Return nullptr if
  /// it cannot be built.
  vtkShaderProgram* Begin(
    const VolumeFrame& frame, const std::array<int, 4>& viewport, VisibleCells* visible = nullptr);
  void End(const VolumeFrame& frame);
  //@}

  /// Return the maximum number of border faces through which a pixel's ray enters. This call draws
  /// and waits for the GPU.
  int CountLayers(const VolumeFrame& frame);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool RenderRayEntries(const VolumeFrame& frame, const std::array<int, 2>& size);

  RayEntries Entries;
  Dependencies Known; // of the entries
};
}

#endif

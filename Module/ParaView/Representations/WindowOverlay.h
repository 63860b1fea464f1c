// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WindowOverlay
 * @brief   blends pictures over the composited one in a window, in the order of VTK on one process
 *
 * VTK smooths edges (FXAA) before it draws volumes, but after translucent objects and volumes that
 * it peels with them. ParaView on several ranks smooths the composited picture. Between
 * BeginFrame() and EndFrame() ParaView does not smooth, and this class does it instead.
 *
 * Private to the module.
 */
#ifndef WindowOverlay_h
#define WindowOverlay_h

#include "vtkNew.h"

#include <array>
#include <vector>

class vtkOpenGLFXAAFilter;
class vtkRenderer;

namespace relevo
{
/// Premultiplied colours and opacities, row by row from the lower left corner.
using ColorPicture = std::vector<float>;

class WindowOverlay
{
public:
  WindowOverlay();
  ~WindowOverlay();

  void BeginFrame(vtkRenderer* renderer);

  /// Set the pictures of the frame. They are blended in this order, before or after smoothing.
  void SetPictures(
    std::vector<ColorPicture> pictures, const std::array<int, 2>& size, bool areSmoothed);

  /// Draw. The renderer has the composited picture.
  void EndFrame(vtkRenderer* renderer);

  bool IsInFrame() const { return this->InFrame; }
  void ReleaseGraphicsResources();

private:
  void Blend(vtkRenderer* renderer);
  void Smooth(vtkRenderer* renderer);

  vtkNew<vtkOpenGLFXAAFilter> Filter;
  bool InFrame = false;
  bool IsSmoothed = false; // in this frame
  bool AreSmoothed = false;
  std::vector<ColorPicture> Pictures;
  std::array<int, 2> Size = { { 0, 0 } };
};
}

#endif

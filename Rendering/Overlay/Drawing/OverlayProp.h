// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OverlayProp
 * @brief   a prop that calls a function to draw over a renderer's pixels
 */
#ifndef OverlayProp_h
#define OverlayProp_h

#include "vtkProp.h"

#include <functional>

namespace relevo
{
class OverlayProp : public vtkProp
{
public:
  static OverlayProp* New();
  vtkTypeMacro(OverlayProp, vtkProp);

  /// Draws, and returns whether anything was drawn.
  std::function<bool(vtkViewport*)> Draw;
  /// Releases what Draw uses in a window.
  std::function<void(vtkWindow*)> Release;

  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  OverlayProp();
  ~OverlayProp() override;

private:
  OverlayProp(const OverlayProp&) = delete;
  void operator=(const OverlayProp&) = delete;
};
}

#endif

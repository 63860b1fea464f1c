// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureRenderer
 * @brief   draws what another renderer shows, in its window's context, at a size of its own
 *
 * It is not in the window's list, and has a camera and copies of the lights of its own, so that
 * nothing of the other renderer changes. Private to the module.
 */
#ifndef CaptureRenderer_h
#define CaptureRenderer_h

#include "vtkOpenGLRenderer.h"

namespace relevo
{
class CaptureRenderer : public vtkOpenGLRenderer
{
public:
  static CaptureRenderer* New();
  vtkTypeMacro(CaptureRenderer, vtkOpenGLRenderer);

  /// Take the window, the lights and the ambient light of another renderer.
  void Follow(vtkRenderer* renderer);
  /// Pixels.
  void SetCaptureSize(int width, int height);
  /// Lights that follow the camera stand where this one's camera is.
  void PlaceLights();

  //@{
  /**
   * Those of the capture: the window's do not matter.
   */
  int* GetSize() override;
  int* GetOrigin() override;
  void GetTiledSizeAndOrigin(int* width, int* height, int* originX, int* originY) override;
  //@}

protected:
  CaptureRenderer() = default;
  ~CaptureRenderer() override;

private:
  CaptureRenderer(const CaptureRenderer&) = delete;
  void operator=(const CaptureRenderer&) = delete;

  int CaptureSize[2] = { 1, 1 };
};
}

#endif

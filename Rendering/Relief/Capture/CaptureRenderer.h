// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureRenderer
 * @brief   draws the scene of another renderer in its window's context, at another size
 *
 * It is not in the window's list of renderers, and has its own camera and copies of the lights, so
 * that the other renderer does not change. Private to the module.
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

  /// Copy the window, the lights and the ambient light of another renderer.
  void Follow(vtkRenderer* renderer);
  /// Set the size in pixels.
  void SetCaptureSize(int width, int height);
  /// Move lights that follow the camera to the camera of this renderer.
  void PlaceLights();

  //@{
  /**
   * These are the size and origin of the capture, not of the window.
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

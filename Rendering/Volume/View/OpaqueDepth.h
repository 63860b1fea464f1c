// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OpaqueDepth
 * @brief   the window depths where the rays of a viewport end, as a texture
 *
 * Private to the module.
 */
#ifndef OpaqueDepth_h
#define OpaqueDepth_h

#include "vtkSmartPointer.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class OpaqueDepth
{
public:
  OpaqueDepth();
  ~OpaqueDepth();

  /// Copy the depths of the current framebuffer, multisampled or not. The viewport is the lower
  /// left corner and size. Return false if the depths cannot be read.
  bool Copy(vtkOpenGLRenderWindow* window, const int viewport[4]);

  /// Use these depths instead, row by row from the lower left corner, and optionally the depths
  /// where rays begin. Return false if they cannot be uploaded.
  bool Upload(vtkOpenGLRenderWindow* window, int width, int height, const float* depths,
    const float* begins = nullptr);

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Allocate(vtkOpenGLRenderWindow* window, const int viewport[4], int format);
  bool Blit(vtkOpenGLRenderWindow* window, const int viewport[4]);

  vtkSmartPointer<vtkTextureObject> Texture;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  int Format = -1;
  bool HasBegins = false;
};
}

#endif

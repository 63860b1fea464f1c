// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayEntries
 * @brief   the number and the identity of the border faces where each pixel's ray enters
 *
 * All border faces are drawn; each pixel tests the faces near it and accumulates. Private to the
 * module.
 */
#ifndef RayEntries_h
#define RayEntries_h

#include "Targets/RenderTarget.h"
#include "View/QuadBatches.h"

namespace relevo
{
class RayEntries
{
public:
  /// Bind the target of this size; Draw() or DrawCounts() restores the framebuffer. Return false if
  /// it cannot be allocated.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height)
  {
    return this->Target.Begin(window, width, height, { { 2 } });
  }
  /// Draw with the program of MakeEntriesShader(), whose uniforms are set.
  void Draw(int numberOfFaces);

  /// Draw with the program of MakeCountShader().
  void DrawCounts();

  /// Activate the texture. The sampler needs one even if it is not read: OpenGL draws nothing if
  /// its texture unit has a buffer texture.
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
  {
    if (!this->Target.GetTexture() && this->Begin(window, 1, 1))
    {
      this->Draw(0);
    }
    this->Target.Activate(program, "rayEntries");
  }
  void Deactivate() { this->Target.Deactivate(); }
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Return the maximum number of entries of a pixel. This call waits for the GPU.
  int ReadMaximum();

private:
  RenderTarget Target;
  QuadBatches Faces;
};
}

#endif

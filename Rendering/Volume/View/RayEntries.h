// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayEntries
 * @brief   for each pixel how many border faces its ray enters through, and which
 *
 * All border faces are drawn, each pixel tests those near to it, and adds up. Private to the
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
  /// Bind the target, of so many pixels; Draw() or DrawCounts() ends that. false if it cannot be
  /// allocated.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height)
  {
    return this->Target.Begin(window, width, height, { { 2 } });
  }
  /// With the program of MakeEntriesShader(), whose uniforms are set.
  void Draw(int numberOfFaces);

  /// The same with that of MakeCountShader().
  void DrawCounts();

  /// A sampler needs a texture, also where it is not read: beside buffer textures in its unit
  /// OpenGL draws nothing.
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

  /// The most entries of any pixel; waits for the GPU.
  int ReadMaximum();

private:
  RenderTarget Target;
  QuadBatches Faces;
};
}

#endif

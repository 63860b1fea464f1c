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

#include "View/FloatTarget.h"

namespace relevo
{
class RayEntries
{
public:
  /// Make the target ready and current, of so many pixels; Draw() ends that. false if there is none
  /// to be had.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height)
  {
    return this->Target.Begin(window, width, height, 2);
  }
  /// With the program of MakeEntriesShader(), whose uniforms are set.
  void Draw(int numberOfFaces) { this->Target.DrawQuads(numberOfFaces, FloatTarget::Mixing::Add); }

  /// The same with that of MakeCountShader().
  void DrawCounts() { this->Target.Draw(3, FloatTarget::Mixing::Add); }

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
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Target.ReleaseGraphicsResources(window);
  }

  /// The most entries of any pixel; waits for the GPU.
  int ReadMost();

private:
  FloatTarget Target;
};
}

#endif

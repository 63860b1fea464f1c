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

#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class RayEntries
{
public:
  RayEntries();
  ~RayEntries();

  /// Make the target ready and current, of so many pixels; Draw() ends that. false if there is none
  /// to be had.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height);
  /// With the program of MakeEntriesShader(), whose uniforms are set.
  void Draw(int numberOfFaces);

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  /// The most entries of any pixel; waits for the GPU.
  int ReadMost();

private:
  vtkSmartPointer<vtkTextureObject> Sums;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Faces;
};
}

#endif

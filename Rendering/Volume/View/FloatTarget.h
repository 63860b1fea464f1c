// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FloatTarget
 * @brief   a texture of floats that triangles are blended into
 *
 * Private to the module.
 */
#ifndef FloatTarget_h
#define FloatTarget_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkOpenGLBufferObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class FloatTarget
{
public:
  FloatTarget();
  ~FloatTarget();

  /// Make it ready and current, of so many pixels; Draw() ends that. false if there is none to be
  /// had.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height, int components);
  /// Over zeros, with the program that is in use, vertices without attributes: what is there
  /// already is added, or what is drawn later covers it by its alpha.
  void Draw(int numberOfVertices, bool covers);
  /// Likewise, of four vertices each.
  void DrawQuads(int numberOfQuads, bool covers);

  void Activate(vtkShaderProgram* program, const std::string& sampler);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  vtkTextureObject* GetTexture() const { return this->Texture; }

private:
  void DrawBlended(bool covers, const std::function<void()>& draw);
  bool BindQuads();

  vtkSmartPointer<vtkTextureObject> Texture;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
  vtkSmartPointer<vtkOpenGLBufferObject> Quads; // of one call
};
}

#endif

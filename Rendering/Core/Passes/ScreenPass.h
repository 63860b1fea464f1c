// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ScreenPass
 * @brief   draws a triangle that covers the viewport, for programs that compute each pixel
 *
 * Unlike vtkOpenGLQuadHelper, this class owns no program and has no vertex buffer. All programs of
 * a mapper share it, and a triangle has no diagonal along which pixels are computed twice. Private
 * to the modules.
 */
#ifndef ScreenPass_h
#define ScreenPass_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkNew.h"                    // for members

#include <functional> // for drawing

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT ScreenPass
{
public:
  ScreenPass();
  ~ScreenPass();
  ScreenPass(const ScreenPass&) = delete;
  void operator=(const ScreenPass&) = delete;

  /// Return the source of the vertex shader that programs must have.
  static const char* GetVertexShader();

  /// Draw the triangle without binding a vertex array object; the caller may have bound one.
  static void DrawTriangle();

  /// Draw with the current program.
  void Draw();

  /// Draw with the current program over the window's pixels, blended by premultiplied alpha,
  /// without depths.
  void DrawOver(vtkOpenGLRenderWindow* window);

  /// Call a function that draws over the window's pixels, blended by premultiplied alpha, without
  /// depths.
  static void BlendOver(vtkOpenGLRenderWindow* window, const std::function<void()>& draw);

  /// Return the vertex array, whose attributes render passes may set.
  vtkOpenGLVertexArrayObject* GetVertices() const { return this->Vertices; }

  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
};
}

#endif

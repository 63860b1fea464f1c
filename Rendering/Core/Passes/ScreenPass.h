// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ScreenPass
 * @brief   one triangle that covers the viewport, for programs that compute each pixel
 *
 * Unlike a vtkOpenGLQuadHelper it owns no program and has no vertex buffer: the programs of one
 * mapper share it, and a triangle has no diagonal where pixels are computed twice. Private to the
 * modules.
 */
#ifndef ScreenPass_h
#define ScreenPass_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkNew.h"                    // for members

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

  /// The source of the vertex shader that programs must have.
  static const char* GetVertexShader();

  /// Draw the bare triangle, which another vertex array object may already be bound for.
  static void DrawTriangle();

  /// By the program that is in use.
  void Draw();

  /// Likewise, over the window's pixels by premultiplied alpha, without depths.
  void DrawOver(vtkOpenGLRenderWindow* window);

  /// Render passes may set its attributes.
  vtkOpenGLVertexArrayObject* GetVertices() const { return this->Vertices; }

  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
};
}

#endif

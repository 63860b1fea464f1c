// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PanelPainter
 * @brief   draws ImGui's triangles by OpenGL
 */
#ifndef PanelPainter_h
#define PanelPainter_h

#include "Drawing/PanelBackground.h"

#include "vtkNew.h"

struct ImDrawData;
struct ImDrawList;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
/// Return the part of a window of this size that panels cover.
PixelRectangle FindRectangle(ImDrawData* panels, const int size[2]);

class PanelPainter
{
public:
  PanelPainter();
  ~PanelPainter();

  /**
   * Draw panels into the window, or into the current tile of a magnified picture. The ImGui context
   * must be current. The font's atlas is uploaded if its version has changed. Return false if the
   * shader cannot be built.
   */
  bool Draw(vtkOpenGLRenderWindow* window, ImDrawData* panels, int fontVersion);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// The pixels of the whole picture, and the part that the window shows.
  struct Tile;

  void UploadFont(vtkOpenGLRenderWindow* window, int version);
  void DrawList(vtkOpenGLRenderWindow* window, const ImDrawList* list, const Tile& tile);
  void SetState(vtkOpenGLRenderWindow* window, const Tile& tile);

  vtkNew<vtkTextureObject> Atlas;
  int AtlasVersion = 0;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkShaderProgram* Program = nullptr; // of the window's cache, during Draw()
};
}

#endif

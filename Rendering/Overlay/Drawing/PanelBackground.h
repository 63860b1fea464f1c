// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PanelBackground
 * @brief   the pixels of the scene that panels cover
 *
 * Stores a rectangle of the current framebuffer before panels are drawn over it. Later frames
 * restore it instead of drawing the scene. Colours are copied with all their samples.
 */
#ifndef PanelBackground_h
#define PanelBackground_h

#include "OpenGL/RelevoOpenGL.h"

#include <array>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace relevo
{
/// The left, lower, right and upper borders in pixels from the lower left corner.
using PixelRectangle = std::array<int, 4>;

class PanelBackground
{
public:
  /// Store the pixels of a rectangle, which may be empty. Without a framebuffer object, nothing is
  /// stored.
  void Store(vtkOpenGLRenderWindow* window, const PixelRectangle& rectangle);
  /// Restore the stored pixels in the current framebuffer.
  void Restore(vtkOpenGLRenderWindow* window);

  bool IsStored() const { return this->HasPixels; }
  /// Forget the pixels.
  void Clear() { this->HasPixels = false; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Reserve(GLint source);

  GLuint Framebuffer = 0;
  GLuint Buffer = 0;
  GLint Samples = 0;
  GLint Format = 0;
  int Size[2] = { 0, 0 };
  PixelRectangle Rectangle = { { 0, 0, 0, 0 } };
  bool HasPixels = false;
};
}

#endif

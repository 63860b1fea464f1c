// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICScreen
 * @brief   a camera's image of an actor's vectors, and its LIC
 *
 * Private to the module's own sources.
 */
#ifndef LICScreen_h
#define LICScreen_h

#include "Changes/Dependencies.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector> // for vectors

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkMatrix4x4;
class vtkWindow;

namespace relevo
{
struct LICScreen
{
  int Viewport[4] = { 0, 0, 0, 0 };          // lower left corner and size, in pixels
  int Rectangle[4] = { 0, 0, 0, 0 };         // of the viewport; contains the whole surface
  int Convolved[4] = { 0, 0, 0, 0 };         // the convolved region: Rectangle, or larger
  int PartOrigin[2] = { 0, 0 };              // origin in a tiled image, in pixels
  vtkSmartPointer<vtkTextureObject> Vectors; // in the format of relevoLICVectorsFS.glsl
  vtkSmartPointer<vtkTextureObject> Colors;  // of the surface, on request
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkTextureObject> Image; // the LIC, and the vectors' flags
  vtkSmartPointer<vtkTextureObject> Range; // of the colours' lightness, on request
  Dependencies Sources;                    // dependencies of Vectors and Image
  unsigned long LastUse = 0;

  bool IsEmpty() const { return this->Viewport[2] < 1 || this->Viewport[3] < 1; }

  /**
   * Allocate textures of the viewport's size. Return false if that fails.
   */
  bool Allocate(vtkOpenGLRenderWindow* window, bool withColors);

  /**
   * Find the rectangle that contains the bounds. `project` maps them to the viewport, from -1 to 1.
   * Pixels outside are not convolved.
   */
  void SetBounds(const double bounds[6], vtkMatrix4x4* project);

  /// Enlarge the convolved region by this number of pixels on all sides.
  void GrowConvolved(int margin);

  /**
   * Draw to the vectors (and colours) until End(), after clearing them. Return false if OpenGL
   * cannot draw to them.
   */
  bool Begin(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer);
  void End(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer);

  //@{
  /// Read the vectors of a rectangle, four floats per pixel, between Begin() and End().
  std::vector<float> ReadVectors(
    vtkOpenGLFramebufferObject* framebuffer, const int rectangle[4]) const;
  void WriteVectors(const int rectangle[4], const std::vector<float>& vectors);
  //@}

  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICScreen
 * @brief   what one camera sees of an actor's vectors, and its LIC
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
  int Rectangle[4] = { 0, 0, 0, 0 };         // of the viewport: nothing of the surface lies outside
  int Convolved[4] = { 0, 0, 0, 0 };         // what is convolved: that, or more
  int PartOrigin[2] = { 0, 0 };              // in a picture that is drawn in parts, in pixels
  vtkSmartPointer<vtkTextureObject> Vectors; // as relevoLICVectorsFS.glsl makes them
  vtkSmartPointer<vtkTextureObject> Colors;  // of the surface, where they are asked for
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkTextureObject> Image; // the LIC, and the vectors' mark
  vtkSmartPointer<vtkTextureObject> Range; // of the colours' lightness, where it is asked for
  Dependencies Sources;                    // what Vectors and Image were made from
  unsigned long LastUse = 0;

  bool IsEmpty() const { return this->Viewport[2] < 1 || this->Viewport[3] < 1; }

  /**
   * Have textures of the viewport's size. False when there are none to be had.
   */
  bool Allocate(vtkOpenGLRenderWindow* window, bool withColors);

  /**
   * Find the rectangle of what lies within bounds: `project` takes them to the viewport, from -1 to
   * 1. What lies outside is not convolved.
   */
  void SetBounds(const double bounds[6], vtkMatrix4x4* project);

  /// Convolve so many pixels more on all sides.
  void GrowConvolved(int margin);

  /**
   * Draw to the vectors (and colours) until End(); what is there is forgotten. False when OpenGL
   * cannot draw to them.
   */
  bool Begin(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer);
  void End(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer);

  //@{
  /// The vectors of a rectangle, four numbers a pixel: reading is between Begin() and End().
  std::vector<float> ReadVectors(
    vtkOpenGLFramebufferObject* framebuffer, const int rectangle[4]) const;
  void WriteVectors(const int rectangle[4], const std::vector<float>& vectors);
  //@}

  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICPass
 * @brief   one program that runs over all pixels of an image
 *
 * Private to the module's own sources.
 */
#ifndef LICPass_h
#define LICPass_h

#include "Passes/ScreenPass.h"

#include <string> // for sources

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

namespace relevo
{
class LICPass
{
public:
  /// Functions of a fragment shader, and the expression of a vec4 that is its result.
  LICPass(const std::string& functions, const std::string& result);
  ~LICPass();
  LICPass(const LICPass&) = delete;
  void operator=(const LICPass&) = delete;

  /// The program, in use; nullptr when it cannot be built.
  vtkShaderProgram* Begin(vtkOpenGLRenderWindow* window);

  /// Have a sampler of the program read a texture, until that is deactivated.
  static void Read(vtkShaderProgram* program, const char* sampler, vtkTextureObject* texture);

  /// Run it over the target, which takes the place of the framebuffer's colours, or over a
  /// rectangle of it, lower left corner and size: the rest of the target is zero then.
  void Draw(vtkOpenGLFramebufferObject* framebuffer, vtkTextureObject* target,
    const int* rectangle = nullptr);

  void ReleaseGraphicsResources();

private:
  std::string Source;
  vtkShaderProgram* Program = nullptr; // of the window's cache
  ScreenPass Screen;
};

/// A texture of floats, one or more a pixel, that can be drawn to; nullptr if there is none to be
/// had.
vtkTextureObject* NewFloatTexture(
  vtkOpenGLRenderWindow* window, int width, int height, int components, bool linear);
}

#endif

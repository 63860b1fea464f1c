// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICPass
 * @brief   a program that runs over all pixels of an image
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
  /// The arguments are functions of a fragment shader, and the vec4 expression of its result.
  LICPass(const std::string& functions, const std::string& result);
  ~LICPass();
  LICPass(const LICPass&) = delete;
  void operator=(const LICPass&) = delete;

  /// Return the program and make it current; nullptr if it cannot be built.
  vtkShaderProgram* Begin(vtkOpenGLRenderWindow* window);

  /// Bind a texture to a sampler of the program, until it is deactivated.
  static void Read(vtkShaderProgram* program, const char* sampler, vtkTextureObject* texture);

  /// Run the program over the target, which replaces the framebuffer's colours, or over a rectangle
  /// of it, given by its lower left corner and size. The rest of the target is set to zero.
  void Draw(vtkOpenGLFramebufferObject* framebuffer, vtkTextureObject* target,
    const int* rectangle = nullptr);

  void ReleaseGraphicsResources();

private:
  std::string Source;
  vtkShaderProgram* Program = nullptr; // owned by the window's cache
  ScreenPass Screen;
};

/// Create a texture of one or more floats per pixel as a render target; nullptr if that fails.
vtkTextureObject* NewFloatTexture(
  vtkOpenGLRenderWindow* window, int width, int height, int components, bool linear);
}

#endif

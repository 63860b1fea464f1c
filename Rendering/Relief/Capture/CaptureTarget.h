// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureTarget
 * @brief   a framebuffer for captures, and its pixels
 *
 * It has colours of 8 bits like a window, depths of 32 bits, and normals and depths that shaders
 * write as floats. There is no multisampling: a pixel shows one surface. Private to the module.
 */
#ifndef CaptureTarget_h
#define CaptureTarget_h

#include "Targets/RenderTarget.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace relevo
{
/// The pixels that were drawn, row by row from the bottom.
struct CapturedPixels
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Colors; ///< red, green, blue
  std::vector<float> ZBuffer;        ///< from 0 at the near plane to 1 at the far one
  std::vector<float> Normals; ///< in camera coordinates, and 1; all 0 if no shader wrote a normal
  std::vector<float> Depths;  ///< 1 / gl_FragCoord.w or 0, and gl_FragDepth, written by a shader
};

class CaptureTarget
{
public:
  /// Colours, normals and depths.
  static constexpr int NumberOfDrawBuffers = 3;

  /// Allocate the framebuffer in the current context of the window. Return the error, or "".
  std::string Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  //@{
  /**
   * Between these calls, OpenGL draws to this framebuffer, which is cleared, in the state in which
   * VTK draws opaque props. End() restores the previous state.
   */
  void Begin();
  void End();
  //@}

  /// Set the number of draw buffers that shaders write to.
  void ActivateDrawBuffers(int number);
  void Read(CapturedPixels& pixels);

private:
  bool Bind();

  RenderTarget Target;
  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
};
}

#endif

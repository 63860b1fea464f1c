// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureTarget
 * @brief   a framebuffer that reliefs are captured in, and what was drawn to it
 *
 * Colours of 8 bits as a window's, depths of 32 bits, and as floats normals and depths that shaders
 * write. Has no multisamples: a pixel shows one surface. Private to the module.
 */
#ifndef CaptureTarget_h
#define CaptureTarget_h

#include "Targets/RenderTarget.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace relevo
{
/// What was drawn, row after row from below.
struct CapturedPixels
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Colors; ///< red, green, blue
  std::vector<float> ZBuffer;        ///< from 0 at the near plane to 1 at the far one
  std::vector<float> Normals;        ///< in the camera's space, and 1; 0 where a shader wrote none
  std::vector<float> Depths;         ///< 1 / gl_FragCoord.w or 0, and gl_FragDepth, by a shader
};

class CaptureTarget
{
public:
  /// Colours, normals and depths.
  static constexpr int NumberOfDrawBuffers = 3;

  /// In the context of the window, which is current; what OpenGL cannot do, or "".
  std::string Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  //@{
  /**
   * What is drawn in between comes here, to an empty framebuffer, with OpenGL in the state that
   * VTK draws opaque props in; what was before Begin() is restored.
   */
  void Begin();
  void End();
  //@}

  /// How many of the draw buffers shaders write to.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SavedOpenGLState
 * @brief   restores OpenGL's state after panels have been drawn
 *
 * VTK's record of the state stays right.
 */
#ifndef SavedOpenGLState_h
#define SavedOpenGLState_h

#include "OpenGL/RelevoOpenGL.h"
#include "vtkOpenGLState.h"

class vtkOpenGLRenderWindow;

namespace relevo
{
class SavedOpenGLState
{
public:
  explicit SavedOpenGLState(vtkOpenGLRenderWindow* window);
  ~SavedOpenGLState();
  SavedOpenGLState(const SavedOpenGLState&) = delete;
  void operator=(const SavedOpenGLState&) = delete;

private:
  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction;
  vtkOpenGLState::ScopedglActiveTexture ActiveTexture;
  GLint BlendEquations[2];
  GLint PolygonModes[2];
  GLint Program = 0;
  GLint VertexArray = 0;
  GLint ArrayBuffer = 0;
  GLint Texture = 0; // of unit 0
  GLint Sampler = 0; // of unit 0
  GLint UnpackAlignment = 0;
};
}

#endif

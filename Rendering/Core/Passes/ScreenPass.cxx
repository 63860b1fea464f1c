// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/ScreenPass.h"

#include "OpenGL/RelevoOpenGL.h"
#include "relevoViewportVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"

namespace relevo
{
ScreenPass::ScreenPass() = default;
ScreenPass::~ScreenPass() = default;

const char* ScreenPass::GetVertexShader()
{
  return relevoViewportVS;
}

void ScreenPass::DrawTriangle()
{
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ScreenPass::Draw()
{
  this->Vertices->Bind();
  DrawTriangle();
  this->Vertices->Release();
}

void ScreenPass::BlendOver(vtkOpenGLRenderWindow* window, const std::function<void()>& draw)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blending(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw();
}

void ScreenPass::DrawOver(vtkOpenGLRenderWindow* window)
{
  BlendOver(window, [this] { this->Draw(); });
}

void ScreenPass::ReleaseGraphicsResources()
{
  this->Vertices->ReleaseGraphicsResources();
}
}

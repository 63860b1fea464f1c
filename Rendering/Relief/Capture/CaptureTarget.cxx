// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/CaptureTarget.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace relevo
{
// The formats are bytes for colours, and floats for normals, depths and the z-buffer.
bool CaptureTarget::Bind()
{
  const RenderTarget::Format colors = { 4, VTK_UNSIGNED_CHAR,
    this->Window->GetUseSRGBColorSpace() };
  return this->Target.Begin(
    this->Window, this->Width, this->Height, { colors, { 4, VTK_FLOAT }, { 2, VTK_FLOAT } }, true);
}

std::string CaptureTarget::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
  GLint viewport[2] = { 0, 0 };
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  if (width > std::min(most, viewport[0]) || height > std::min(most, viewport[1]))
  {
    return "A capture of " + size + " is larger than the largest framebuffer of this OpenGL: " +
      std::to_string(std::min(most, viewport[0])) + " x " +
      std::to_string(std::min(most, viewport[1])) + ".";
  }
  this->Window = window;
  this->Width = width;
  this->Height = height;
  const std::string error = "OpenGL cannot create a framebuffer of " + size + " for a capture.";
  if (!this->Bind())
  {
    return error;
  }
  const char* description = nullptr;
  const bool isComplete =
    vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, description);
  this->Target.End();
  return isComplete ? "" : error;
}

void CaptureTarget::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->Push();
  this->Bind();
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void CaptureTarget::End()
{
  this->Target.End();
  this->Window->GetState()->Pop();
}

void CaptureTarget::ActivateDrawBuffers(int number)
{
  this->Target.GetFramebuffer()->ActivateDrawBuffers(static_cast<unsigned int>(number));
}

void CaptureTarget::Read(CapturedPixels& pixels)
{
  vtkOpenGLState* state = this->Window->GetState();
  const size_t number = static_cast<size_t>(this->Width) * this->Height;
  pixels.Width = this->Width;
  pixels.Height = this->Height;
  pixels.Colors.resize(3 * number);
  pixels.Normals.resize(4 * number);
  pixels.Depths.resize(2 * number);
  pixels.ZBuffer.resize(number);
  this->Bind();
  vtkOpenGLFramebufferObject* framebuffer = this->Target.GetFramebuffer();
  const auto read = [this](unsigned int format, unsigned int type, void* data)
  { glReadPixels(0, 0, this->Width, this->Height, format, type, data); };
  GLint alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  framebuffer->ActivateReadBuffer(0);
  read(GL_RGB, GL_UNSIGNED_BYTE, pixels.Colors.data());
  read(GL_DEPTH_COMPONENT, GL_FLOAT, pixels.ZBuffer.data());
  framebuffer->ActivateReadBuffer(1);
  read(GL_RGBA, GL_FLOAT, pixels.Normals.data());
  framebuffer->ActivateReadBuffer(2);
  read(GL_RG, GL_FLOAT, pixels.Depths.data());
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, alignment);
  this->Target.End();
}
}

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
CaptureTarget::CaptureTarget() = default;
CaptureTarget::~CaptureTarget() = default;

std::string CaptureTarget::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
  GLint viewport[2] = { 0, 0 };
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  if (width > std::min(most, viewport[0]) || height > std::min(most, viewport[1]))
  {
    return "A capture of " + size +
      " is larger than what OpenGL can draw to: " + std::to_string(std::min(most, viewport[0])) +
      " x " + std::to_string(std::min(most, viewport[1])) + ".";
  }
  this->Window = window;
  this->Width = width;
  this->Height = height;
  const std::string problem = "OpenGL cannot make a framebuffer of " + size + " for a capture.";
  const auto w = static_cast<unsigned int>(width);
  const auto h = static_cast<unsigned int>(height);
  for (vtkTextureObject* texture :
    { this->Colors.Get(), this->Normals.Get(), this->Depths.Get(), this->ZBuffer.Get() })
  {
    texture->SetContext(window);
  }
  this->Colors->SetUseSRGBColorSpace(window->GetUseSRGBColorSpace());
  if (!this->Colors->Create2D(w, h, 4, VTK_UNSIGNED_CHAR, false) ||
    !this->Normals->Create2D(w, h, 4, VTK_FLOAT, false) ||
    !this->Depths->Create2D(w, h, 2, VTK_FLOAT, false) ||
    !this->ZBuffer->AllocateDepth(w, h, vtkTextureObject::Float32))
  {
    return problem;
  }
  this->Framebuffer->SetContext(window);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Colors);
  this->Framebuffer->AddColorAttachment(1, this->Normals);
  this->Framebuffer->AddColorAttachment(2, this->Depths);
  this->Framebuffer->AddDepthAttachment(this->ZBuffer);
  this->Framebuffer->ActivateDrawBuffers(NumberOfDrawBuffers);
  const char* description = nullptr;
  const bool isComplete =
    vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, description);
  state->PopFramebufferBindings();
  return isComplete ? "" : problem;
}

void CaptureTarget::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->Push();
  this->Framebuffer->Bind();
  this->ActivateDrawBuffers(NumberOfDrawBuffers);
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
  this->Window->GetState()->Pop();
}

void CaptureTarget::ActivateDrawBuffers(int number)
{
  this->Framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(number));
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
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  const auto read = [this](unsigned int format, unsigned int type, void* data)
  { glReadPixels(0, 0, this->Width, this->Height, format, type, data); };
  GLint alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  this->Framebuffer->ActivateReadBuffer(0);
  read(GL_RGB, GL_UNSIGNED_BYTE, pixels.Colors.data());
  read(GL_DEPTH_COMPONENT, GL_FLOAT, pixels.ZBuffer.data());
  this->Framebuffer->ActivateReadBuffer(1);
  read(GL_RGBA, GL_FLOAT, pixels.Normals.data());
  this->Framebuffer->ActivateReadBuffer(2);
  read(GL_RG, GL_FLOAT, pixels.Depths.data());
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, alignment);
  state->PopFramebufferBindings();
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RayEntries.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPixelBufferObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

namespace relevo
{
RayEntries::RayEntries() = default;
RayEntries::~RayEntries() = default;

bool RayEntries::Begin(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (!this->Sums || static_cast<int>(this->Sums->GetWidth()) != width ||
    static_cast<int>(this->Sums->GetHeight()) != height)
  {
    this->ReleaseGraphicsResources(window);
    this->Sums = vtkSmartPointer<vtkTextureObject>::New();
    this->Sums->SetContext(window);
    this->Sums->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Sums->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
    if (!this->Sums->Create2D(
          static_cast<unsigned int>(width), static_cast<unsigned int>(height), 2, VTK_FLOAT, false))
    {
      this->ReleaseGraphicsResources(window);
      return false;
    }
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Sums);
  this->Framebuffer->ActivateDrawBuffer(0);
  return true;
}

void RayEntries::Draw(int numberOfFaces)
{
  vtkOpenGLState* state = this->Framebuffer->GetContext()->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blending(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  GLint equations[2] = { GL_FUNC_ADD, GL_FUNC_ADD };
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equations[1]);
  state->vtkglViewport(
    0, 0, static_cast<int>(this->Sums->GetWidth()), static_cast<int>(this->Sums->GetHeight()));
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  this->Faces->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 6 * numberOfFaces);
  this->Faces->Release();
  state->vtkglBlendEquationSeparate(
    static_cast<unsigned int>(equations[0]), static_cast<unsigned int>(equations[1]));
  state->PopFramebufferBindings();
}

void RayEntries::Activate(vtkShaderProgram* program)
{
  if (this->Sums && program->IsUniformUsed("rayEntries"))
  {
    this->Sums->Activate();
    program->SetUniformi("rayEntries", this->Sums->GetTextureUnit());
  }
}

void RayEntries::Deactivate()
{
  if (this->Sums)
  {
    this->Sums->Deactivate();
  }
}

void RayEntries::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Sums)
  {
    this->Sums->ReleaseGraphicsResources(window);
    this->Sums = nullptr;
  }
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  this->Faces->ReleaseGraphicsResources();
}

int RayEntries::ReadMost()
{
  if (!this->Sums)
  {
    return 0;
  }
  vtkSmartPointer<vtkPixelBufferObject> pixels;
  pixels.TakeReference(this->Sums->Download());
  const unsigned int size = this->Sums->GetWidth() * this->Sums->GetHeight();
  std::vector<float> sums(2 * static_cast<size_t>(size));
  unsigned int dimensions[2] = { this->Sums->GetWidth(), this->Sums->GetHeight() };
  vtkIdType increments[2] = { 0, 0 };
  pixels->Download2D(VTK_FLOAT, sums.data(), dimensions, 2, increments);
  float most = 0.0f;
  for (size_t i = 1; i < sums.size(); i += 2)
  {
    most = std::max(most, sums[i]);
  }
  return static_cast<int>(most);
}
}

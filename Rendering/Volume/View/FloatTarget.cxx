// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/FloatTarget.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
constexpr int QuadsPerCall = 16384; // whose corners have numbers of 16 bits
}

FloatTarget::FloatTarget() = default;
FloatTarget::~FloatTarget() = default;

bool FloatTarget::Begin(vtkOpenGLRenderWindow* window, int width, int height, int components)
{
  if (!this->Texture || static_cast<int>(this->Texture->GetWidth()) != width ||
    static_cast<int>(this->Texture->GetHeight()) != height)
  {
    this->ReleaseGraphicsResources(window);
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
    if (!this->Texture->Create2D(static_cast<unsigned int>(width),
          static_cast<unsigned int>(height), components, VTK_FLOAT, false))
    {
      this->ReleaseGraphicsResources(window);
      return false;
    }
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Texture);
  this->Framebuffer->ActivateDrawBuffer(0);
  return true;
}

void FloatTarget::Draw(int numberOfVertices, bool covers)
{
  this->DrawBlended(covers, [=]() { glDrawArrays(GL_TRIANGLES, 0, numberOfVertices); });
}

bool FloatTarget::BindQuads()
{
  if (this->Quads)
  {
    return this->Quads->Bind();
  }
  std::vector<unsigned short> corners;
  corners.reserve(6 * static_cast<size_t>(QuadsPerCall));
  for (int quad = 0; quad < QuadsPerCall; ++quad)
  {
    for (int corner : { 0, 1, 2, 0, 2, 3 })
    {
      corners.push_back(static_cast<unsigned short>(4 * quad + corner));
    }
  }
  this->Quads = vtkSmartPointer<vtkOpenGLBufferObject>::New();
  this->Quads->SetType(vtkOpenGLBufferObject::ElementArrayBuffer);
  return this->Quads->Upload(corners, vtkOpenGLBufferObject::ElementArrayBuffer);
}

void FloatTarget::DrawQuads(int numberOfQuads, bool covers)
{
  this->DrawBlended(covers,
    [=]()
    {
      if (!this->BindQuads())
      {
        return;
      }
      for (int first = 0; first < numberOfQuads; first += QuadsPerCall)
      {
        glDrawElementsBaseVertex(GL_TRIANGLES, 6 * std::min(QuadsPerCall, numberOfQuads - first),
          GL_UNSIGNED_SHORT, nullptr, 4 * first);
      }
      this->Quads->Release();
    });
}

void FloatTarget::DrawBlended(bool covers, const std::function<void()>& draw)
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
  state->vtkglViewport(0, 0, static_cast<int>(this->Texture->GetWidth()),
    static_cast<int>(this->Texture->GetHeight()));
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  const unsigned int kept = covers ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE;
  state->vtkglBlendFuncSeparate(GL_ONE, kept, GL_ONE, kept);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  this->Vertices->Bind();
  draw();
  this->Vertices->Release();
  state->vtkglBlendEquationSeparate(
    static_cast<unsigned int>(equations[0]), static_cast<unsigned int>(equations[1]));
  state->PopFramebufferBindings();
}

void FloatTarget::Activate(vtkShaderProgram* program, const std::string& sampler)
{
  if (this->Texture && program->IsUniformUsed(sampler.c_str()))
  {
    this->Texture->Activate();
    program->SetUniformi(sampler.c_str(), this->Texture->GetTextureUnit());
  }
}

void FloatTarget::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

void FloatTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  if (this->Quads)
  {
    this->Quads->ReleaseGraphicsResources();
    this->Quads = nullptr;
  }
  this->Vertices->ReleaseGraphicsResources();
}
}

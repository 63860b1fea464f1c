// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Targets/RenderTarget.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace relevo
{
RenderTarget::RenderTarget() = default;
RenderTarget::~RenderTarget() = default;

vtkTextureObject* RenderTarget::GetTexture(size_t texture) const
{
  return texture < this->Textures.size() ? this->Textures[texture].Get() : nullptr;
}

vtkOpenGLFramebufferObject* RenderTarget::GetFramebuffer() const
{
  return this->Framebuffer;
}

bool RenderTarget::Has(
  int width, int height, const std::vector<Format>& formats, bool hasDepth) const
{
  vtkTextureObject* first = this->GetTexture();
  return first && this->Formats == formats && static_cast<int>(first->GetWidth()) == width &&
    static_cast<int>(first->GetHeight()) == height && (this->Depth != nullptr) == hasDepth;
}

bool RenderTarget::Create(vtkOpenGLRenderWindow* window, int width, int height,
  const std::vector<Format>& formats, bool hasDepth)
{
  const unsigned int columns = static_cast<unsigned int>(width);
  const unsigned int rows = static_cast<unsigned int>(height);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  for (const Format& format : formats)
  {
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Linear);
    texture->SetMagnificationFilter(vtkTextureObject::Linear);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    texture->SetUseSRGBColorSpace(format.IsSRGB);
    this->Textures.push_back(texture);
    if (!texture->Create2D(columns, rows, format.Components, format.Type, false))
    {
      return false;
    }
  }
  this->Formats = formats;
  if (hasDepth)
  {
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(window);
    return this->Depth->AllocateDepth(columns, rows, vtkTextureObject::Float32);
  }
  return true;
}

bool RenderTarget::Begin(vtkOpenGLRenderWindow* window, int width, int height,
  const std::vector<Format>& formats, bool hasDepth)
{
  if (!this->Has(width, height, formats, hasDepth))
  {
    this->ReleaseGraphicsResources(window);
    if (!this->Create(window, width, height, formats, hasDepth))
    {
      this->ReleaseGraphicsResources(window);
      return false;
    }
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  for (size_t i = 0; i < this->Textures.size(); ++i)
  {
    this->Framebuffer->AddColorAttachment(static_cast<unsigned int>(i), this->Textures[i]);
  }
  if (this->Depth)
  {
    this->Framebuffer->AddDepthAttachment(this->Depth);
  }
  this->Framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(this->Textures.size()));
  return true;
}

void RenderTarget::End()
{
  this->Framebuffer->GetContext()->GetState()->PopFramebufferBindings();
}

// The write masks of the operation apply.
void RenderTarget::Clear(BlendOperation operation)
{
  const float value = IsExtremum(operation) ? Empty : 0.0f;
  const float colors[4] = { value, value, value, value };
  for (size_t i = 0; i < this->Textures.size(); ++i)
  {
    glClearBufferfv(GL_COLOR, static_cast<GLint>(i), colors);
  }
  if (NeedsDepth(operation))
  {
    const float depth = operation == BlendOperation::Maximum ? 0.0f : 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &depth);
  }
}

void RenderTarget::Draw(BlendOperation operation, const std::function<void()>& draw, int channel)
{
  vtkOpenGLState* state = this->Framebuffer->GetContext()->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blending(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  GLint equations[2] = { GL_FUNC_ADD, GL_FUNC_ADD };
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equations[1]);
  const bool needsDepth = NeedsDepth(operation);
  const auto isDrawn = [=](int i) { return channel < 0 || channel == i; };
  state->vtkglViewport(0, 0, static_cast<int>(this->GetTexture()->GetWidth()),
    static_cast<int>(this->GetTexture()->GetHeight()));
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(isDrawn(0), isDrawn(1), isDrawn(2), isDrawn(3));
  state->vtkglDepthMask(needsDepth ? GL_TRUE : GL_FALSE);
  state->vtkglDepthFunc(operation == BlendOperation::Maximum ? GL_GEQUAL : GL_LEQUAL);
  state->SetEnumState(GL_DEPTH_TEST, needsDepth);
  state->SetEnumState(GL_BLEND, !needsDepth);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  const unsigned int kept = operation == BlendOperation::Over ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE;
  state->vtkglBlendFuncSeparate(GL_ONE, kept, GL_ONE, kept);
  this->Clear(operation);
  this->Vertices->Bind();
  draw();
  this->Vertices->Release();
  state->vtkglBlendEquationSeparate(
    static_cast<unsigned int>(equations[0]), static_cast<unsigned int>(equations[1]));
}

void RenderTarget::Activate(vtkShaderProgram* program, const std::string& sampler, size_t texture)
{
  if (texture < this->Textures.size() && program->IsUniformUsed(sampler.c_str()))
  {
    this->Textures[texture]->Activate();
    program->SetUniformi(sampler.c_str(), this->Textures[texture]->GetTextureUnit());
  }
}

void RenderTarget::Deactivate()
{
  for (vtkTextureObject* texture : this->Textures)
  {
    texture->Deactivate();
  }
}

void RenderTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextureObject* texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Textures.clear();
  this->Formats.clear();
  if (this->Depth)
  {
    this->Depth->ReleaseGraphicsResources(window);
    this->Depth = nullptr;
  }
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  this->Vertices->ReleaseGraphicsResources();
}
}

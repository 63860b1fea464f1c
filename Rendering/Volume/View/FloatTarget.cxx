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

vtkTextureObject* FloatTarget::GetTexture() const
{
  return this->Textures.empty() ? nullptr : this->Textures[0].Get();
}

bool FloatTarget::Has(int width, int height, int numberOfTextures, bool hasDepth) const
{
  vtkTextureObject* first = this->GetTexture();
  return static_cast<int>(this->Textures.size()) == numberOfTextures &&
    static_cast<int>(first->GetWidth()) == width &&
    static_cast<int>(first->GetHeight()) == height && (this->Depth != nullptr) == hasDepth;
}

bool FloatTarget::Create(vtkOpenGLRenderWindow* window, int width, int height, int components,
  int numberOfTextures, bool hasDepth)
{
  const unsigned int columns = static_cast<unsigned int>(width);
  const unsigned int rows = static_cast<unsigned int>(height);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  for (int i = 0; i < numberOfTextures; ++i)
  {
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Linear);
    texture->SetMagnificationFilter(vtkTextureObject::Linear);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Textures.push_back(texture);
    if (!texture->Create2D(columns, rows, components, VTK_FLOAT, false))
    {
      return false;
    }
  }
  if (hasDepth)
  {
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(window);
    return this->Depth->AllocateDepth(columns, rows, vtkTextureObject::Float32);
  }
  return true;
}

bool FloatTarget::Begin(vtkOpenGLRenderWindow* window, int width, int height, int components,
  int numberOfTextures, bool hasDepth)
{
  if (!this->Has(width, height, numberOfTextures, hasDepth))
  {
    this->ReleaseGraphicsResources(window);
    if (!this->Create(window, width, height, components, numberOfTextures, hasDepth))
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

void FloatTarget::Draw(int numberOfVertices, Mixing mixing)
{
  this->DrawBlended(mixing, -1, [=]() { glDrawArrays(GL_TRIANGLES, 0, numberOfVertices); });
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

void FloatTarget::DrawQuads(int numberOfQuads, Mixing mixing, int channel)
{
  this->DrawBlended(mixing, channel,
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

// With what the state has for the mixing.
void FloatTarget::Clear(Mixing mixing)
{
  const bool isExtreme = mixing == Mixing::Highest || mixing == Mixing::Lowest;
  const float value = isExtreme ? None : 0.0f;
  const float colors[4] = { value, value, value, value };
  for (size_t i = 0; i < this->Textures.size(); ++i)
  {
    glClearBufferfv(GL_COLOR, static_cast<GLint>(i), colors);
  }
  if (isExtreme)
  {
    const float depth = mixing == Mixing::Highest ? 0.0f : 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &depth);
  }
}

void FloatTarget::DrawBlended(Mixing mixing, int channel, const std::function<void()>& draw)
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
  const bool isExtreme = mixing == Mixing::Highest || mixing == Mixing::Lowest;
  const auto isDrawn = [=](int i) { return channel < 0 || channel == i; };
  state->vtkglViewport(0, 0, static_cast<int>(this->GetTexture()->GetWidth()),
    static_cast<int>(this->GetTexture()->GetHeight()));
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(isDrawn(0), isDrawn(1), isDrawn(2), isDrawn(3));
  state->vtkglDepthMask(isExtreme ? GL_TRUE : GL_FALSE);
  state->vtkglDepthFunc(mixing == Mixing::Highest ? GL_GEQUAL : GL_LEQUAL);
  state->SetEnumState(GL_DEPTH_TEST, isExtreme);
  state->SetEnumState(GL_BLEND, !isExtreme);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  const unsigned int kept = mixing == Mixing::Cover ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE;
  state->vtkglBlendFuncSeparate(GL_ONE, kept, GL_ONE, kept);
  this->Clear(mixing);
  this->Vertices->Bind();
  draw();
  this->Vertices->Release();
  state->vtkglBlendEquationSeparate(
    static_cast<unsigned int>(equations[0]), static_cast<unsigned int>(equations[1]));
  state->PopFramebufferBindings();
}

void FloatTarget::Activate(vtkShaderProgram* program, const std::string& sampler, size_t texture)
{
  if (texture < this->Textures.size() && program->IsUniformUsed(sampler.c_str()))
  {
    this->Textures[texture]->Activate();
    program->SetUniformi(sampler.c_str(), this->Textures[texture]->GetTextureUnit());
  }
}

void FloatTarget::Deactivate()
{
  for (vtkTextureObject* texture : this->Textures)
  {
    texture->Deactivate();
  }
}

void FloatTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextureObject* texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Textures.clear();
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
  if (this->Quads)
  {
    this->Quads->ReleaseGraphicsResources();
    this->Quads = nullptr;
  }
  this->Vertices->ReleaseGraphicsResources();
}
}

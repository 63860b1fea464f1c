// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/OpaqueDepth.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

namespace relevo
{
namespace
{
// A blit requires the format of the source.
enum Formats
{
  Fixed24,
  WithStencil,
  Fixed32,
  Float32,
  Fixed16,
  NumberOfFormats
};

// Guess the format of the current framebuffer from OpenGL's queries; another format may have the
// same size.
int GuessFormat()
{
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  const auto get = [drawn](unsigned int ofFramebuffer, unsigned int ofWindow, unsigned int what)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, drawn != 0 ? ofFramebuffer : ofWindow, what, &value);
    return value;
  };
  const auto getOfDepth = [&get](unsigned int what)
  { return get(GL_DEPTH_ATTACHMENT, GL_DEPTH, what); };
  if (getOfDepth(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
  {
    return Fixed24;
  }
  if (getOfDepth(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return Float32;
  }
  const bool hasStencil =
    get(GL_STENCIL_ATTACHMENT, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
  const GLint size = getOfDepth(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  return size == 32 ? Fixed32 : size == 16 ? Fixed16 : hasStencil ? WithStencil : Fixed24;
}
}

OpaqueDepth::OpaqueDepth() = default;
OpaqueDepth::~OpaqueDepth() = default;

bool OpaqueDepth::Allocate(vtkOpenGLRenderWindow* window, const int viewport[4], int format)
{
  const unsigned int width = static_cast<unsigned int>(viewport[2]);
  const unsigned int height = static_cast<unsigned int>(viewport[3]);
  if (this->Texture && this->Format == format && this->Texture->GetWidth() == width &&
    this->Texture->GetHeight() == height)
  {
    return true;
  }
  this->ReleaseGraphicsResources(window);
  this->HasBegins = false;
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const int formats[] = { vtkTextureObject::Fixed24, 0, vtkTextureObject::Fixed32,
    vtkTextureObject::Float32, vtkTextureObject::Fixed16 };
  this->Format = format;
  return format == WithStencil ? this->Texture->AllocateDepthStencil(width, height)
                               : this->Texture->AllocateDepth(width, height, formats[format]);
}

bool OpaqueDepth::Blit(vtkOpenGLRenderWindow* window, const int viewport[4])
{
  vtkOpenGLState* state = window->GetState();
  if (!this->Framebuffer)
  {
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
  }
  // The scissor rectangle of a viewport is set in window coordinates and affects blits, too.
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  state->PushFramebufferBindings();
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddDepthAttachment(this->Texture);
  glDrawBuffer(GL_NONE);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn));
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glBlitFramebuffer(viewport[0], viewport[1], viewport[0] + viewport[2], viewport[1] + viewport[3],
    0, 0, viewport[2], viewport[3], GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  const bool isCopied = glGetError() == GL_NO_ERROR;
  state->PopFramebufferBindings();
  return isCopied;
}

bool OpaqueDepth::Copy(vtkOpenGLRenderWindow* window, const int viewport[4])
{
  const int first = this->Format >= 0 ? this->Format : GuessFormat();
  for (int i = 0; i < NumberOfFormats; ++i)
  {
    if (this->Allocate(window, viewport, (first + i) % NumberOfFormats) &&
      this->Blit(window, viewport))
    {
      return true;
    }
  }
  return false;
}

bool OpaqueDepth::Upload(
  vtkOpenGLRenderWindow* window, int width, int height, const float* depths, const float* begins)
{
  std::vector<float> pairs;
  if (begins)
  {
    const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    for (size_t i = 0; i < pixels; ++i)
    {
      pairs.push_back(depths[i]);
      pairs.push_back(begins[i]);
    }
  }
  this->ReleaseGraphicsResources(window);
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const bool isUploaded = this->Texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), begins ? 2 : 1, VTK_FLOAT,
    begins ? pairs.data() : const_cast<float*>(depths));
  this->Format = -1;
  this->HasBegins = begins != nullptr;
  return isUploaded;
}

void OpaqueDepth::Activate(vtkShaderProgram* program)
{
  if (this->Texture && program->IsUniformUsed("opaqueDepth"))
  {
    this->Texture->Activate();
    program->SetUniformi("opaqueDepth", this->Texture->GetTextureUnit());
    program->SetUniformi("hasBegins", this->HasBegins ? 1 : 0);
  }
}

void OpaqueDepth::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

void OpaqueDepth::ReleaseGraphicsResources(vtkWindow* window)
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
}
}

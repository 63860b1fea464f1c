// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PanelBackground.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>

namespace relevo
{
namespace
{
GLint GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

// Restores the framebuffers that blits use. VTK's record of the bindings stays right.
class SavedFramebuffers
{
public:
  explicit SavedFramebuffers(vtkOpenGLRenderWindow* window)
    : Scissor(window->GetState(), GL_SCISSOR_TEST)
    , Draw(GetInteger(GL_DRAW_FRAMEBUFFER_BINDING))
    , Read(GetInteger(GL_READ_FRAMEBUFFER_BINDING))
    , Renderbuffer(GetInteger(GL_RENDERBUFFER_BINDING))
  {
    window->GetState()->vtkglDisable(GL_SCISSOR_TEST); // it also limits blits
  }
  ~SavedFramebuffers()
  {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(this->Draw));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(this->Read));
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(this->Renderbuffer));
  }
  SavedFramebuffers(const SavedFramebuffers&) = delete;
  void operator=(const SavedFramebuffers&) = delete;

  GLint GetDraw() const { return this->Draw; }

private:
  vtkOpenGLState::ScopedglEnableDisable Scissor;
  GLint Draw;
  GLint Read;
  GLint Renderbuffer;
};

// The internal format of the colours that are drawn, or 0 if it is unknown.
GLint FindFormat(GLint attachment, GLint samples)
{
  const auto get = [&](GLenum name)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, static_cast<GLenum>(attachment), name, &value);
    return value;
  };
  const GLint type = get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  GLint format = 0;
  if (type == GL_RENDERBUFFER)
  {
    glBindRenderbuffer(
      GL_RENDERBUFFER, static_cast<GLuint>(get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)));
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
  }
  else if (type == GL_TEXTURE)
  {
    const GLenum target = samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    const GLint bound =
      GetInteger(samples > 0 ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D);
    glBindTexture(target, static_cast<GLuint>(get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)));
    glGetTexLevelParameteriv(target, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    glBindTexture(target, static_cast<GLuint>(bound));
  }
  return format;
}
}

//------------------------------------------------------------------------------
bool PanelBackground::Reserve(GLint source)
{
  const int width = this->Rectangle[2] - this->Rectangle[0];
  const int height = this->Rectangle[3] - this->Rectangle[1];
  const GLint samples = GetInteger(GL_SAMPLES);
  const GLint format = FindFormat(GetInteger(GL_DRAW_BUFFER), samples);
  if (source == 0 || format == 0)
  {
    return false;
  }
  if (this->Buffer != 0 && this->Samples == samples && this->Format == format &&
    this->Size[0] >= width && this->Size[1] >= height)
  {
    return true;
  }
  if (this->Buffer == 0)
  {
    glGenFramebuffers(1, &this->Framebuffer);
    glGenRenderbuffers(1, &this->Buffer);
  }
  this->Samples = samples;
  this->Format = format;
  this->Size[0] = std::max(this->Size[0], width);
  this->Size[1] = std::max(this->Size[1], height);
  glBindRenderbuffer(GL_RENDERBUFFER, this->Buffer);
  glRenderbufferStorageMultisample(
    GL_RENDERBUFFER, samples, static_cast<GLenum>(format), this->Size[0], this->Size[1]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  glFramebufferRenderbuffer(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, this->Buffer);
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

//------------------------------------------------------------------------------
void PanelBackground::Store(vtkOpenGLRenderWindow* window, const PixelRectangle& rectangle)
{
  this->Rectangle = rectangle;
  const auto [left, bottom, right, top] = rectangle;
  this->HasPixels = left >= right || bottom >= top;
  if (this->HasPixels)
  {
    return;
  }
  const SavedFramebuffers saved(window);
  const GLint drawn = GetInteger(GL_DRAW_BUFFER);
  if (!this->Reserve(saved.GetDraw()))
  {
    return;
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(saved.GetDraw()));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  const GLint read = GetInteger(GL_READ_BUFFER);
  glReadBuffer(static_cast<GLenum>(drawn));
  glBlitFramebuffer(
    left, bottom, right, top, 0, 0, right - left, top - bottom, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glReadBuffer(static_cast<GLenum>(read));
  this->HasPixels = true;
}

//------------------------------------------------------------------------------
void PanelBackground::Restore(vtkOpenGLRenderWindow* window)
{
  const auto [left, bottom, right, top] = this->Rectangle;
  if (!this->HasPixels || left >= right || bottom >= top)
  {
    return;
  }
  const SavedFramebuffers saved(window);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer);
  glBlitFramebuffer(
    0, 0, right - left, top - bottom, left, bottom, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

//------------------------------------------------------------------------------
void PanelBackground::ReleaseGraphicsResources(vtkWindow* window)
{
  this->HasPixels = false;
  if (this->Buffer != 0)
  {
    auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
    if (context)
    {
      context->PushContext();
    }
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteRenderbuffers(1, &this->Buffer);
    if (context)
    {
      context->PopContext();
    }
  }
  this->Framebuffer = 0;
  this->Buffer = 0;
  this->Size[0] = 0;
  this->Size[1] = 0;
}
}

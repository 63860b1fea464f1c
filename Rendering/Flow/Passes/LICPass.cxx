// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICPass.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace relevo
{
LICPass::LICPass(const std::string& functions, const std::string& result)
  : Source("//VTK::System::Dec\n//VTK::Output::Dec\n#define RELEVO_FUNCTION\n"
           "#define RELEVO_UNUSED\n" +
      functions + "void main()\n{\n  gl_FragData[0] = " + result + ";\n}\n")
{
}

LICPass::~LICPass() = default;

vtkShaderProgram* LICPass::Begin(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  this->Program = this->Program
    ? cache->ReadyShaderProgram(this->Program)
    : cache->ReadyShaderProgram(ScreenPass::GetVertexShader(), this->Source.c_str(), "");
  return this->Program;
}

void LICPass::Read(vtkShaderProgram* program, const char* sampler, vtkTextureObject* texture)
{
  texture->Activate();
  if (program->IsUniformUsed(sampler))
  {
    program->SetUniformi(sampler, texture->GetTextureUnit());
  }
}

void LICPass::Draw(
  vtkOpenGLFramebufferObject* framebuffer, vtkTextureObject* target, const int* rectangle)
{
  framebuffer->AddColorAttachment(0, target);
  framebuffer->ActivateDrawBuffer(0);
  framebuffer->InitializeViewport(
    static_cast<int>(target->GetWidth()), static_cast<int>(target->GetHeight()));
  vtkOpenGLState* state = framebuffer->GetContext()->GetState();
  if (rectangle)
  {
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
  }
  this->Screen.Draw();
  if (rectangle)
  {
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
}

void LICPass::ReleaseGraphicsResources()
{
  this->Program = nullptr;
  this->Screen.ReleaseGraphicsResources();
}

vtkTextureObject* NewFloatTexture(
  vtkOpenGLRenderWindow* window, int width, int height, int components, bool linear)
{
  vtkTextureObject* texture = vtkTextureObject::New();
  texture->SetContext(window);
  const int filter = linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToBorder);
  texture->SetWrapT(vtkTextureObject::ClampToBorder);
  texture->SetBorderColor(0.0f, 0.0f, 0.0f, 0.0f);
  if (!texture->Create2D(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
        components, VTK_FLOAT, false))
  {
    texture->Delete();
    return nullptr;
  }
  return texture;
}
}

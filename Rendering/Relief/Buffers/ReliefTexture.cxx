// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ReliefTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace relevo
{
vtkSmartPointer<vtkTextureObject> MakeReliefTexture(
  vtkOpenGLRenderWindow* window, const ivec2& size, const void* values, int components, int type)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  void* data = const_cast<void*>(values);
  return texture->Create2DFromRaw(size.x, size.y, components, type, data) ? texture : nullptr;
}

void ActivateReliefTexture(
  vtkShaderProgram* program, vtkTextureObject* texture, const char* sampler)
{
  if (texture && program->IsUniformUsed(sampler))
  {
    texture->Activate();
    program->SetUniformi(sampler, texture->GetTextureUnit());
  }
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/HeightTextures.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace relevo
{
HeightTextures::HeightTextures() = default;
HeightTextures::~HeightTextures() = default;

bool HeightTextures::Upload(vtkOpenGLRenderWindow* window, vtkDisplacement* displacement)
{
  if (!displacement)
  {
    this->ReleaseGraphicsResources(window);
    return true;
  }
  vtkHeightField* heights = displacement->GetHeightMap();
  const bool withValidity = displacement->HasHoles();
  Dependencies dependencies = Dependencies::On(withValidity);
  dependencies.AddObject(heights, heights ? heights->GetSamplesMTime() : 0);
  if (this->Heights && this->HeightDependencies == dependencies)
  {
    return true;
  }
  int size[2] = { 1, 1 };
  if (heights)
  {
    heights->GetDimensions(size);
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (size[0] > most || size[1] > most)
  {
    this->Error = "the height map has " + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " samples, but textures of this OpenGL have at most " +
      std::to_string(most) + " per side: call SetMaximumDimension(" + std::to_string(most) +
      ") of vtkHeightMap";
    return false;
  }
  this->ReleaseGraphicsResources(window);
  if (!this->Create(window, heights, size, withValidity))
  {
    this->Error = "the height map's texture could not be created";
    this->ReleaseGraphicsResources(window);
    return false;
  }
  this->HeightDependencies = dependencies;
  return true;
}

bool HeightTextures::Create(
  vtkOpenGLRenderWindow* window, vtkHeightField* heights, const int size[2], bool withValidity)
{
  static float zero = 0.0f;
  const unsigned int width = static_cast<unsigned int>(size[0]);
  const unsigned int height = static_cast<unsigned int>(size[1]);
  auto create = [&](vtkSmartPointer<vtkTextureObject>& texture, int type, const void* data)
  {
    texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    return texture->Create2DFromRaw(width, height, 1, type, const_cast<void*>(data));
  };
  bool created = create(this->Heights, VTK_FLOAT, heights ? heights->GetSamples() : &zero);
  this->MemorySize = static_cast<vtkTypeInt64>(width) * height * sizeof(float);
  if (withValidity)
  {
    created = create(this->Validity, VTK_UNSIGNED_CHAR, heights->GetValidity()) && created;
    this->MemorySize += static_cast<vtkTypeInt64>(width) * height;
  }
  return created;
}

void HeightTextures::Activate(vtkShaderProgram* program)
{
  auto activate = [program](vtkTextureObject* texture, const char* sampler)
  {
    if (texture && program->IsUniformUsed(sampler))
    {
      texture->Activate();
      program->SetUniformi(sampler, texture->GetTextureUnit());
    }
  };
  activate(this->Heights, "relevoHeights");
  activate(this->Validity, "relevoValidity");
}

void HeightTextures::Deactivate()
{
  for (vtkTextureObject* texture : { this->Heights.Get(), this->Validity.Get() })
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}

void HeightTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkSmartPointer<vtkTextureObject>* texture : { &this->Heights, &this->Validity })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->MemorySize = 0;
}
}

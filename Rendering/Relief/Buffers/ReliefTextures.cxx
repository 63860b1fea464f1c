// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ReliefTextures.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Buffers/ReliefTiles.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

namespace relevo
{
namespace
{
template <typename T>
vtkSmartPointer<vtkTextureObject> MakeTexture(vtkOpenGLRenderWindow* window, const ivec2& size,
  const std::vector<T>& values, int components, int type)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  void* data = const_cast<T*>(values.data());
  return texture->Create2DFromRaw(size.x, size.y, components, type, data) ? texture : nullptr;
}

void ActivateTexture(vtkShaderProgram* program, vtkTextureObject* texture, const char* sampler)
{
  if (texture && program->IsUniformUsed(sampler))
  {
    texture->Activate();
    program->SetUniformi(sampler, texture->GetTextureUnit());
  }
}
}

int ReliefTextures::GetLargestSize()
{
  GLint size = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
  return size;
}

bool ReliefTextures::Upload(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles)
{
  this->ReleaseGraphicsResources(window);
  const ivec2 size = tiles.GetTextureSize();
  if (tiles.GetNumberOfTiles() == 0)
  {
    return true;
  }
  if (max(size.x, size.y) > GetLargestSize())
  {
    return false;
  }
  std::vector<float> places;
  for (const vec4& place : tiles.GetPlaces())
  {
    places.insert(places.end(), { place.x, place.y, place.z, place.w });
  }
  this->Heights = MakeTexture(window, size, tiles.GetHeights(), 1, VTK_FLOAT);
  this->Colors = MakeTexture(window, size, tiles.GetColors(), 4, VTK_UNSIGNED_CHAR);
  const bool hasNormals = !tiles.GetNormals().empty();
  if (hasNormals)
  {
    this->Normals = MakeTexture(window, size, tiles.GetNormals(), 2, VTK_UNSIGNED_SHORT);
  }
  const bool valid = this->Places.Upload(window, places, 4) &&
    this->Quads.Upload(window, tiles.GetQuads()) &&
    this->Ranges.Upload(window, tiles.GetRanges(), 2) && this->Heights && this->Colors &&
    (this->Normals || !hasNormals);
  if (!valid)
  {
    this->ReleaseGraphicsResources(window);
    return false;
  }
  this->NumberOfTiles = tiles.GetNumberOfTiles();
  this->TilesPerRow = tiles.GetTilesPerRow();
  this->TextureMemory = static_cast<vtkTypeInt64>(size.x) * size.y * (hasNormals ? 12 : 8);
  return true;
}

vtkTypeInt64 ReliefTextures::GetMemorySize() const
{
  return this->TextureMemory + this->Places.GetMemorySize() + this->Quads.GetMemorySize() +
    this->Ranges.GetMemorySize();
}

void ReliefTextures::Activate(vtkShaderProgram* program)
{
  this->Places.Activate(program, "reliefPlaces");
  this->Quads.Activate(program, "reliefQuads");
  this->Ranges.Activate(program, "reliefRanges");
  ActivateTexture(program, this->Heights, "reliefHeights");
  ActivateTexture(program, this->Colors, "reliefColors");
  ActivateTexture(program, this->Normals, "reliefNormals");
  program->SetUniformi("reliefTilesPerRow", this->TilesPerRow);
}

void ReliefTextures::Deactivate()
{
  for (RefinementBuffer* buffer : { &this->Places, &this->Quads, &this->Ranges })
  {
    buffer->Deactivate();
  }
  for (vtkTextureObject* texture : { this->Heights.Get(), this->Colors.Get(), this->Normals.Get() })
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}

void ReliefTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (RefinementBuffer* buffer : { &this->Places, &this->Quads, &this->Ranges })
  {
    buffer->ReleaseGraphicsResources(window);
  }
  for (vtkSmartPointer<vtkTextureObject>* texture :
    { &this->Heights, &this->Colors, &this->Normals })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->NumberOfTiles = 0;
  this->TextureMemory = 0;
}
}

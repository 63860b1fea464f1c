// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ReliefTextures.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Buffers/ReliefCones.h"
#include "Buffers/ReliefTexture.h"
#include "Buffers/ReliefTiles.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

namespace relevo
{
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
  this->Heights = MakeReliefTexture(window, size, tiles.GetHeights().data(), 1, VTK_FLOAT);
  this->Colors = MakeReliefTexture(window, size, tiles.GetColors().data(), 4, VTK_UNSIGNED_CHAR);
  const bool hasNormals = !tiles.GetNormals().empty();
  if (hasNormals)
  {
    this->Normals =
      MakeReliefTexture(window, size, tiles.GetNormals().data(), 2, VTK_UNSIGNED_SHORT);
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

bool ReliefTextures::UploadGrid(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles)
{
  return this->Grid.Upload(window, tiles.GetGrid(), 1);
}

bool ReliefTextures::UploadCones(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles)
{
  const std::vector<unsigned char> cones = MakeReliefCones(tiles);
  this->Cones =
    MakeReliefTexture(window, tiles.GetTextureSize(), cones.data(), 1, VTK_UNSIGNED_CHAR);
  this->TextureMemory += this->Cones ? static_cast<vtkTypeInt64>(cones.size()) : 0;
  return this->HasCones();
}

vtkTypeInt64 ReliefTextures::GetMemorySize() const
{
  return this->TextureMemory + this->Places.GetMemorySize() + this->Quads.GetMemorySize() +
    this->Ranges.GetMemorySize() + this->Grid.GetMemorySize();
}

void ReliefTextures::Activate(vtkShaderProgram* program)
{
  this->Places.Activate(program, "reliefPlaces");
  this->Quads.Activate(program, "reliefQuads");
  this->Ranges.Activate(program, "reliefRanges");
  this->Grid.Activate(program, "reliefTileGrid");
  ActivateReliefTexture(program, this->Heights, "reliefHeights");
  ActivateReliefTexture(program, this->Colors, "reliefColors");
  ActivateReliefTexture(program, this->Normals, "reliefNormals");
  ActivateReliefTexture(program, this->Cones, "reliefCones");
  program->SetUniformi("reliefTilesPerRow", this->TilesPerRow);
}

void ReliefTextures::Deactivate()
{
  for (BufferTexture* buffer : { &this->Places, &this->Quads, &this->Ranges, &this->Grid })
  {
    buffer->Deactivate();
  }
  for (vtkTextureObject* texture :
    { this->Heights.Get(), this->Colors.Get(), this->Normals.Get(), this->Cones.Get() })
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}

void ReliefTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (BufferTexture* buffer : { &this->Places, &this->Quads, &this->Ranges, &this->Grid })
  {
    buffer->ReleaseGraphicsResources(window);
  }
  for (vtkSmartPointer<vtkTextureObject>* texture :
    { &this->Heights, &this->Colors, &this->Normals, &this->Cones })
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainInstances.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Lattice/BlockErrors.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

namespace relevo
{
namespace
{
// The numbers of relevoTerrainFaceVS.glsl.
unsigned int PackShape(const TerrainFace& face)
{
  unsigned int shape = static_cast<unsigned int>(face.Level - BlockErrors::FinestLevel);
  int bit = 5;
  for (int step : { face.Step1[0], face.Step1[1], face.Step2[0], face.Step2[1] })
  {
    shape |= static_cast<unsigned int>(step + 1) << bit;
    bit += 2;
  }
  return shape | (face.Made == TerrainFace::Origin::Edge ? 1u << bit : 0u);
}

// Compares bits, because heights may be NaN.
bool AreSameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}
}

vtkIdType TerrainInstances::GetMaximumNumberOfFaces()
{
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  return texels;
}

void TerrainInstances::SetMemoryLimit(vtkTypeInt64 bytes)
{
  this->MemoryLimit = bytes;
}

// A height tile needs a texture of heights and one of gradients.
int TerrainInstances::GetMaximumNumberOfTiles() const
{
  return static_cast<int>(std::min<vtkTypeInt64>(TerrainTileTextures::GetMaximumNumberOfLayers(),
    this->MemoryLimit / 2 / TerrainTileTextures::LayerSize));
}

// Without imagery, heights and gradients have a half of the limit each. With imagery, the division
// only changes if a texture needs more than its share, because a texture of another size is
// uploaded again.
bool TerrainInstances::UploadTextures(
  vtkOpenGLRenderWindow* window, const std::array<TileList, 3>& tiles)
{
  const std::array<TerrainTileTextures*, 3> textures = { { &this->Tiles, &this->Gradients,
    &this->Imagery } };
  const int half = this->GetMaximumNumberOfTiles();
  this->IsImageryUsed = !tiles[2].empty();
  if (!this->IsImageryUsed)
  {
    this->Imagery.ReleaseGraphicsResources();
    this->MaximumNumbers = { { half, half, 0 } };
  }
  std::array<int, 3> numbers;
  int spare = 2 * half;
  bool fits =
    2 * half >= std::accumulate(this->MaximumNumbers.begin(), this->MaximumNumbers.end(), 0);
  for (int i = 0; i < 3; ++i)
  {
    numbers[i] = TerrainTileTextures::CountTiles(tiles[i]);
    spare -= numbers[i];
    fits = fits && numbers[i] <= this->MaximumNumbers[i];
  }
  if (!fits && (spare < 0 || !this->IsImageryUsed))
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    this->MaximumNumbers[i] = fits ? this->MaximumNumbers[i] : numbers[i] + spare / 3;
    textures[i]->SetMemoryLimit(this->MaximumNumbers[i] * TerrainTileTextures::LayerSize);
  }
  bool isUploaded = true;
  // First the textures that shrink, so that the limit holds at all times.
  for (bool isShrinking : { true, false })
  {
    for (int i = 0; i < 3; ++i)
    {
      if (textures[i]->IsTooLarge() || (!isShrinking && !tiles[i].empty()))
      {
        isUploaded = textures[i]->Upload(window, tiles[i]) && isUploaded;
      }
    }
  }
  return isUploaded;
}

std::string TerrainInstances::UploadTiles(vtkOpenGLRenderWindow* window,
  const std::vector<TerrainFace>& faces, const std::vector<MipmapTiles::Item>& shading)
{
  std::array<TileList, 3> tiles;
  TileList& heights = tiles[0];
  for (const TerrainFace& face : faces)
  {
    heights.insert(heights.end(), { face.Tile, face.CoarseTile });
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  // Every fragment finds a gradient: at least that of its face.
  const std::size_t tilesOfFaces = heights.size();
  tiles[1] = heights;
  for (const MipmapTiles::Item& item : shading)
  {
    tiles[item.Tile->GetKind() == TerrainTile::Kind::Heights ? 1 : 2].push_back(item.Tile);
  }
  if (this->HasHeights)
  {
    tiles[0] = tiles[1]; // fits, because the gradients do
  }
  if (!this->UploadTextures(window, tiles))
  {
    return "The tiles of the frame do not fit into graphics memory: at most " +
      std::to_string(this->GetMaximumNumberOfTiles()) + ". Set a larger memory limit.";
  }
  this->Table.Reset(tiles[1].size() + tiles[2].size());
  for (const MipmapTiles::Item& item : shading)
  {
    this->Table.Add(item,
      item.Tile->GetKind() == TerrainTile::Kind::Heights ? this->GetLayers(*item.Tile)
                                                         : this->Imagery.GetLayer(*item.Tile));
  }
  for (std::size_t i = 0; i < tilesOfFaces; ++i)
  {
    this->Table.Add({ tiles[1][i], 1.0f }, this->GetLayers(*tiles[1][i]));
  }
  return this->Table.Upload(window) ? ""
                                    : "The graphics memory does not suffice for a table of tiles.";
}

// Return the layer of the gradients and, if fragments need it, that of the heights.
int TerrainInstances::GetLayers(const TerrainTile& tile) const
{
  return this->Gradients.GetLayer(tile) | (this->HasHeights ? this->Tiles.GetLayer(tile) << 16 : 0);
}

void TerrainInstances::ForgetTiles()
{
  this->Tiles.Clear();
  this->Gradients.Clear();
  this->Imagery.Clear();
}

vtkIdType TerrainInstances::GetNumberOfTileUploads() const
{
  return this->Tiles.GetNumberOfUploads() + this->Gradients.GetNumberOfUploads() +
    this->Imagery.GetNumberOfUploads();
}

void TerrainInstances::AddGroup(const std::vector<TerrainFace>& faces,
  const std::vector<Kind>& kinds, bool isSmall, bool isPositive)
{
  Group& group = this->Groups[isSmall ? 1 : 0][isPositive ? 1 : 0];
  group.First = static_cast<int>(this->Ids.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (kinds[i] == (isSmall ? Kind::Small : Kind::Large) && faces[i].IsPositive() == isPositive)
    {
      this->Ids.push_back(static_cast<unsigned int>(i));
    }
  }
  group.Count = static_cast<int>(this->Ids.size()) - group.First;
}

std::string TerrainInstances::Upload(vtkOpenGLRenderWindow* window,
  const std::vector<TerrainFace>& faces, const std::vector<Kind>& kinds,
  const std::vector<MipmapTiles::Item>& shading)
{
  const std::string error = this->UploadTiles(window, faces, shading);
  if (!error.empty())
  {
    return error;
  }
  this->Ids.clear();
  for (bool isSmall : { false, true })
  {
    for (bool isPositive : { false, true })
    {
      this->AddGroup(faces, kinds, isSmall, isPositive);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (kinds[i] == Kind::Border)
    {
      this->Ids.push_back(static_cast<unsigned int>(i));
    }
  }
  std::vector<unsigned int> integers;
  std::vector<float> floats;
  for (unsigned int id : this->Ids)
  {
    const TerrainFace& face = faces[id];
    integers.insert(integers.end(),
      { static_cast<unsigned int>(face.Apex[0]), static_cast<unsigned int>(face.Apex[1]),
        PackShape(face),
        static_cast<unsigned int>(this->Tiles.GetLayer(*face.Tile)) |
          static_cast<unsigned int>(this->Tiles.GetLayer(*face.CoarseTile)) << 16 });
    floats.insert(floats.end(),
      { face.Morph, face.CornerHeights[0], face.CornerHeights[1], face.CornerHeights[2] });
  }
  const bool isSame = !this->IntegerTexture.IsEmpty() && integers == this->Integers &&
    AreSameBits(floats, this->Floats);
  if (isSame)
  {
    return "";
  }
  this->Integers.swap(integers);
  this->Floats.swap(floats);
  return this->IntegerTexture.Upload(window, this->Integers, 4) &&
      this->FloatTexture.Upload(window, this->Floats, 4)
    ? ""
    : "The frame has too many faces for a buffer texture of this OpenGL: at most " +
      std::to_string(GetMaximumNumberOfFaces()) + ". Set a larger screen-space error.";
}

bool TerrainInstances::UploadIds(vtkOpenGLRenderWindow* window)
{
  return this->IdTexture.Upload(window, this->Ids);
}

void TerrainInstances::Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  this->Tiles.Activate(window, program, "relevoTiles");
  this->Gradients.Activate(window, program, "relevoTileGradients");
  this->Imagery.Activate(window, program, "relevoImagery");
  this->Table.Activate(program);
  this->IntegerTexture.Activate(program, "relevoFaces");
  this->FloatTexture.Activate(program, "relevoFaceHeights");
  this->IdTexture.Activate(program, "relevoFaceIds");
}

void TerrainInstances::Deactivate(vtkOpenGLRenderWindow* window)
{
  this->Tiles.Deactivate(window);
  this->Gradients.Deactivate(window);
  this->Imagery.Deactivate(window);
  this->Table.Deactivate();
  this->IntegerTexture.Deactivate();
  this->FloatTexture.Deactivate();
  this->IdTexture.Deactivate();
}

vtkTypeInt64 TerrainInstances::GetMemorySize() const
{
  return this->Tiles.GetMemorySize() + this->Gradients.GetMemorySize() +
    this->Imagery.GetMemorySize() + this->Table.GetMemorySize() +
    this->IntegerTexture.GetMemorySize() + this->FloatTexture.GetMemorySize() +
    this->IdTexture.GetMemorySize();
}

void TerrainInstances::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Tiles.ReleaseGraphicsResources();
  this->Gradients.ReleaseGraphicsResources();
  this->Imagery.ReleaseGraphicsResources();
  this->Table.ReleaseGraphicsResources(window);
  this->IntegerTexture.ReleaseGraphicsResources(window);
  this->FloatTexture.ReleaseGraphicsResources(window);
  this->IdTexture.ReleaseGraphicsResources(window);
}
}

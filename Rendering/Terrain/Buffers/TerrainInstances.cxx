// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainInstances.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Lattice/BlockErrors.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cstring>
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

std::string TerrainInstances::UploadTiles(vtkOpenGLRenderWindow* window,
  const std::vector<TerrainFace>& faces, const std::vector<MipmapTiles::Item>& shading)
{
  std::vector<const HeightTile*> heights;
  for (const TerrainFace& face : faces)
  {
    heights.insert(heights.end(), { face.Tile, face.CoarseTile });
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  // Every fragment finds a gradient: at least that of its face.
  std::vector<const TerrainTile*> gradients(heights.begin(), heights.end());
  for (const MipmapTiles::Item& item : shading)
  {
    gradients.push_back(item.Tile);
  }
  if (!this->Tiles.Upload(window, { heights.begin(), heights.end() }) ||
    !this->Gradients.Upload(window, gradients))
  {
    return "The heights of the frame do not fit into graphics memory: at most " +
      std::to_string(this->GetMaximumNumberOfTiles()) + " tiles. Set a larger memory limit.";
  }
  this->Table.Reset(gradients.size());
  for (const MipmapTiles::Item& item : shading)
  {
    this->Table.Add(item, this->Gradients.GetLayer(*item.Tile));
  }
  for (const HeightTile* tile : heights)
  {
    this->Table.Add({ tile, 1.0f }, this->Gradients.GetLayer(*tile));
  }
  return this->Table.Upload(window) ? ""
                                    : "The graphics memory does not suffice for a table of tiles.";
}

void TerrainInstances::SetMemoryLimit(vtkTypeInt64 bytes)
{
  this->Tiles.SetMemoryLimit(bytes / 2);
  this->Gradients.SetMemoryLimit(bytes / 2);
}

void TerrainInstances::ForgetTiles()
{
  this->Tiles.Clear();
  this->Gradients.Clear();
}

vtkIdType TerrainInstances::GetNumberOfTileUploads() const
{
  return this->Tiles.GetNumberOfUploads() + this->Gradients.GetNumberOfUploads();
}

std::string TerrainInstances::Upload(vtkOpenGLRenderWindow* window,
  const std::vector<TerrainFace>& faces, const std::vector<MipmapTiles::Item>& shading)
{
  const std::string error = this->UploadTiles(window, faces, shading);
  if (!error.empty())
  {
    return error;
  }
  std::vector<unsigned int> integers;
  std::vector<float> floats;
  this->Ids.clear();
  for (bool isPositive : { false, true })
  {
    Group& group = this->Groups[isPositive ? 1 : 0];
    group.First = static_cast<int>(this->Ids.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const TerrainFace& face = faces[i];
      if (face.IsPositive() == isPositive)
      {
        this->Ids.push_back(static_cast<unsigned int>(i));
        integers.insert(integers.end(),
          { static_cast<unsigned int>(face.Apex[0]), static_cast<unsigned int>(face.Apex[1]),
            PackShape(face),
            static_cast<unsigned int>(this->Tiles.GetLayer(*face.Tile)) |
              static_cast<unsigned int>(this->Tiles.GetLayer(*face.CoarseTile)) << 16 });
        floats.insert(floats.end(),
          { face.Morph, face.CornerHeights[0], face.CornerHeights[1], face.CornerHeights[2] });
      }
    }
    group.Count = static_cast<int>(this->Ids.size()) - group.First;
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
  this->Table.Activate(program);
  this->IntegerTexture.Activate(program, "relevoFaces");
  this->FloatTexture.Activate(program, "relevoFaceHeights");
  this->IdTexture.Activate(program, "relevoFaceIds");
}

void TerrainInstances::Deactivate(vtkOpenGLRenderWindow* window)
{
  this->Tiles.Deactivate(window);
  this->Gradients.Deactivate(window);
  this->Table.Deactivate();
  this->IntegerTexture.Deactivate();
  this->FloatTexture.Deactivate();
  this->IdTexture.Deactivate();
}

vtkTypeInt64 TerrainInstances::GetMemorySize() const
{
  return this->Tiles.GetMemorySize() + this->Gradients.GetMemorySize() +
    this->Table.GetMemorySize() + this->IntegerTexture.GetMemorySize() +
    this->FloatTexture.GetMemorySize() + this->IdTexture.GetMemorySize();
}

void TerrainInstances::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Tiles.ReleaseGraphicsResources();
  this->Gradients.ReleaseGraphicsResources();
  this->Table.ReleaseGraphicsResources(window);
  this->IntegerTexture.ReleaseGraphicsResources(window);
  this->FloatTexture.ReleaseGraphicsResources(window);
  this->IdTexture.ReleaseGraphicsResources(window);
}
}

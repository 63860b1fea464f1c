// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainTileTextures.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Lattice/HeightTile.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_set>
#include <utility>

namespace relevo
{
namespace
{
constexpr int FirstCapacity = 16;

constexpr float LargestHalf = 65504.0f;
constexpr float SmallestNormalHalf = 1.0f / 16384.0f;

// Tiles whose gradients are computed at the same time.
constexpr std::size_t TilesPerBatch = 8;

using Half = std::uint16_t;

std::uint32_t GetBits(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

// The nearest half float, of two the even one, for values up to LargestHalf. OpenGL drivers convert
// one value at a time; without branches, compilers convert several.
Half ToHalf(float value)
{
  const std::uint32_t bits = GetBits(value);
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  // The sum has the bits of a subnormal half at its end.
  const std::uint32_t subnormal = GetBits(std::abs(value) + 0.5f) - GetBits(0.5f);
  constexpr std::uint32_t exponents = (127u - 15u) << 23;
  const std::uint32_t normal = (magnitude - exponents + 0xfffu + (bits >> 13 & 1u)) >> 13;
  const std::uint32_t isNormal =
    magnitude >= GetBits(SmallestNormalHalf) ? ~std::uint32_t(0) : 0u; // a mask
  const std::uint32_t sign = bits >> 16 & 0x8000u;
  return static_cast<Half>(sign | (isNormal & normal) | (~isNormal & subnormal));
}

struct TexelFormat
{
  GLint Internal;
  GLenum Format;
  GLenum Type;
  GLint Filter;
};

TexelFormat GetFormat(TerrainTileTextures::Content content)
{
  switch (content)
  {
    case TerrainTileTextures::Content::HEIGHTS:
    case TerrainTileTextures::Content::NUMBERS:
      return { GL_R32F, GL_RED, GL_FLOAT, GL_NEAREST };
    case TerrainTileTextures::Content::GRADIENTS:
      return { GL_RG16F, GL_RG, GL_HALF_FLOAT, GL_LINEAR };
    default:
      return { GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR };
  }
}

// The central difference, or a difference of two if one neighbour has no data.
float GetDifference(float before, float here, float after)
{
  if (std::isnan(before))
  {
    return after - here;
  }
  return std::isnan(after) ? here - before : 0.5f * (after - before);
}

// The mean of the differences of three rows or columns with Horn's weights, among those that have
// data.
float GetHornMean(const std::array<float, 3>& differences)
{
  float sum = 0.0f;
  float weights = 0.0f;
  for (int i = 0; i < 3; ++i)
  {
    if (std::isfinite(differences[i]))
    {
      const float weight = i == 1 ? 2.0f : 1.0f;
      sum += weight * differences[i];
      weights += weight;
    }
  }
  return weights > 0.0f ? std::clamp(sum / weights, -LargestHalf, LargestHalf) : 0.0f;
}

// Sums of heights up to this one are finite.
constexpr float LargestPlainHeight = 1e30f;

constexpr int TileStride = TerrainTile::Stride;

// The gradient at a vertex that has eight neighbours with data.
void ComputeInnerGradient(const float* height, float* gradient)
{
  const float* above = height - TileStride;
  const float* below = height + TileStride;
  const float columns =
    above[1] - above[-1] + 2.0f * (height[1] - height[-1]) + below[1] - below[-1];
  const float rows = below[-1] - above[-1] + 2.0f * (below[0] - above[0]) + below[1] - above[1];
  gradient[0] = std::clamp(0.125f * columns, -LargestHalf, LargestHalf);
  gradient[1] = std::clamp(0.125f * rows, -LargestHalf, LargestHalf);
}

void ComputeOuterGradient(const HeightTile& tile, int column, int row, float* gradient)
{
  const auto get = [&tile](int i, int j)
  {
    return i < 0 || i >= TileStride || j < 0 || j >= TileStride
      ? std::numeric_limits<float>::quiet_NaN()
      : tile.Heights[static_cast<std::size_t>(j) * TileStride + i];
  };
  std::array<float, 3> columns;
  std::array<float, 3> rows;
  for (int k = -1; k <= 1; ++k)
  {
    columns[k + 1] =
      GetDifference(get(column - 1, row + k), get(column, row + k), get(column + 1, row + k));
    rows[k + 1] =
      GetDifference(get(column + k, row - 1), get(column + k, row), get(column + k, row + 1));
  }
  gradient[0] = GetHornMean(columns);
  gradient[1] = GetHornMean(rows);
}

// The differences to the next column and row, vertex by vertex.
void ComputeGradients(const HeightTile& tile, Half* halves)
{
  const bool isComplete = std::all_of(tile.Heights.begin(), tile.Heights.end(),
    [](float height) { return std::abs(height) <= LargestPlainHeight; }); // not NaN
  std::array<float, std::size_t(2) * TileStride> gradients;
  for (int row = 0; row < TileStride; ++row)
  {
    const bool isInner = isComplete && row > 0 && row < TileStride - 1;
    const float* heights = &tile.Heights[static_cast<std::size_t>(row) * TileStride];
    for (int column = 1; isInner && column < TileStride - 1; ++column)
    {
      ComputeInnerGradient(heights + column, &gradients[2 * column]);
    }
    for (int column = 0; column < TileStride; column += isInner ? TileStride - 1 : 1)
    {
      ComputeOuterGradient(tile, column, row, &gradients[2 * column]);
    }
    halves = std::transform(gradients.begin(), gradients.end(), halves, ToHalf);
  }
}
}

TerrainTileTextures::TerrainTileTextures(Content content)
  : Stored(content)
{
}

void TerrainTileTextures::SetContent(Content content)
{
  if (content != this->Stored)
  {
    this->ReleaseGraphicsResources();
    this->Stored = content;
  }
}

int TerrainTileTextures::CountTiles(const std::vector<const TerrainTile*>& tiles)
{
  std::unordered_set<std::uint64_t> keys;
  for (const TerrainTile* tile : tiles)
  {
    keys.insert(GetTileKey(*tile));
  }
  return static_cast<int>(keys.size());
}

int TerrainTileTextures::GetMaximumNumberOfLayers()
{
  GLint layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  return layers;
}

bool TerrainTileTextures::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<const TerrainTile*>& tiles)
{
  ++this->Frame;
  std::unordered_map<std::uint64_t, const TerrainTile*> needed;
  for (const TerrainTile* tile : tiles)
  {
    needed.emplace(GetTileKey(*tile), tile);
  }
  const int number = static_cast<int>(needed.size());
  const int most = static_cast<int>(
    std::min<vtkTypeInt64>(GetMaximumNumberOfLayers(), this->MemoryLimit / LayerSize));
  if (number > most)
  {
    return false;
  }
  // A lower limit shrinks the texture.
  if ((number > this->Capacity || this->Capacity > most) &&
    !this->Allocate(
      window, std::min(std::max({ number, 2 * this->Capacity, FirstCapacity }), most)))
  {
    return false;
  }
  std::vector<std::pair<std::uint64_t, const TerrainTile*>> added;
  for (const auto& entry : needed)
  {
    const auto known = this->Layers.find(entry.first);
    if (known == this->Layers.end())
    {
      added.emplace_back(entry);
    }
    else
    {
      known->second.LastUse = this->Frame;
    }
  }
  if (added.empty())
  {
    return true;
  }
  const std::vector<int> free = this->FindFreeLayers(added.size());
  this->Bind(window);
  std::vector<const TerrainTile*> batch;
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    batch.push_back(added[i].second);
    this->Layers[added[i].first] = { free[i], this->Frame };
    if (batch.size() == TilesPerBatch || i + 1 == added.size())
    {
      this->UploadTiles(batch, &free[i + 1 - batch.size()]);
      batch.clear();
    }
  }
  this->NumberOfUploads += static_cast<vtkIdType>(added.size());
  this->Deactivate(window);
  return true;
}

// The texture is bound.
void TerrainTileTextures::UploadTiles(
  const std::vector<const TerrainTile*>& tiles, const int* layers) const
{
  constexpr std::size_t halvesPerTile = 2 * TerrainTile::NumberOfVertices;
  std::vector<Half> gradients;
  if (this->Stored == Content::GRADIENTS)
  {
    gradients.resize(tiles.size() * halvesPerTile);
    vtkSMPTools::For(0, static_cast<vtkIdType>(tiles.size()),
      [&](vtkIdType first, vtkIdType end)
      {
        for (vtkIdType i = first; i < end; ++i)
        {
          ComputeGradients(
            static_cast<const HeightTile&>(*tiles[i]), &gradients[i * halvesPerTile]);
        }
      });
  }
  const TexelFormat format = GetFormat(this->Stored);
  for (std::size_t i = 0; i < tiles.size(); ++i)
  {
    const void* texels = gradients.empty() ? tiles[i]->GetValues() : &gradients[i * halvesPerTile];
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layers[i], TerrainTile::Stride,
      TerrainTile::Stride, 1, format.Format, format.Type, texels);
  }
}

// Returns layers that this frame does not use, the empty ones first, and removes their tiles.
std::vector<int> TerrainTileTextures::FindFreeLayers(std::size_t number)
{
  std::vector<bool> isUsed(this->Capacity, false);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> old; // last use, key
  for (const auto& entry : this->Layers)
  {
    isUsed[entry.second.Index] = true;
    if (entry.second.LastUse != this->Frame)
    {
      old.emplace_back(entry.second.LastUse, entry.first);
    }
  }
  std::vector<int> free;
  for (int i = 0; i < this->Capacity && free.size() < number; ++i)
  {
    if (!isUsed[i])
    {
      free.push_back(i);
    }
  }
  std::sort(old.begin(), old.end());
  for (std::size_t i = 0; i < old.size() && free.size() < number; ++i)
  {
    const auto found = this->Layers.find(old[i].second);
    free.push_back(found->second.Index);
    this->Layers.erase(found);
  }
  return free;
}

// Makes an empty texture.
bool TerrainTileTextures::Allocate(vtkOpenGLRenderWindow* window, int capacity)
{
  this->ReleaseGraphicsResources(); // first, so that the limit holds at all times
  glGenTextures(1, &this->Texture);
  this->Bind(window);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  const TexelFormat format = GetFormat(this->Stored);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, format.Internal, TerrainTile::Stride, TerrainTile::Stride,
    capacity, 0, format.Format, format.Type, nullptr);
  const bool isAllocated = glGetError() == GL_NO_ERROR;
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, format.Filter);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, format.Filter);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  this->Deactivate(window);
  if (isAllocated)
  {
    this->Capacity = capacity;
  }
  else
  {
    this->ReleaseGraphicsResources();
  }
  return isAllocated;
}

void TerrainTileTextures::Bind(vtkOpenGLRenderWindow* window)
{
  this->Unit = window->GetTextureUnitManager()->Allocate();
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->Unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Texture);
}

int TerrainTileTextures::GetLayer(const TerrainTile& tile) const
{
  return this->Layers.at(GetTileKey(tile)).Index;
}

void TerrainTileTextures::Activate(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const char* sampler)
{
  if (this->Texture && program->IsUniformUsed(sampler))
  {
    this->Bind(window);
    program->SetUniformi(sampler, this->Unit);
  }
}

void TerrainTileTextures::Deactivate(vtkOpenGLRenderWindow* window)
{
  if (this->Unit >= 0)
  {
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->Unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    window->GetTextureUnitManager()->Free(this->Unit);
    this->Unit = -1;
  }
}

void TerrainTileTextures::ReleaseGraphicsResources()
{
  if (this->Texture)
  {
    glDeleteTextures(1, &this->Texture);
    this->Texture = 0;
  }
  this->Capacity = 0;
  this->Layers.clear();
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainTileTable.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// The numbers of relevoTerrainGradientFS.glsl.
constexpr unsigned int HashFactor = 2654435769u;
constexpr int ColumnBits = 13;
constexpr int VisibilityShift = 16;
constexpr float LargestVisibility = 65535.0f;

unsigned int GetTableKey(const HeightTile& tile)
{
  return (static_cast<unsigned int>(tile.Level) << (2 * ColumnBits) |
           static_cast<unsigned int>(tile.Row) << ColumnBits |
           static_cast<unsigned int>(tile.Column)) +
    1u;
}
}

// At most half of the entries are used, so that searches are short.
void TerrainTileTable::Reset(std::size_t number)
{
  this->Bits = 4;
  while ((std::size_t(1) << this->Bits) < 2 * number)
  {
    ++this->Bits;
  }
  this->CoarsestLevel = 0;
  this->Entries.assign(std::size_t(2) << this->Bits, 0u);
}

void TerrainTileTable::Add(const MipmapTiles::Item& tile, int layer)
{
  const unsigned int key = GetTableKey(*tile.Tile);
  std::size_t entry = (key * HashFactor) >> (32 - this->Bits);
  while (this->Entries[2 * entry] != 0u)
  {
    if (this->Entries[2 * entry] == key)
    {
      return;
    }
    entry = (entry + 1) & ((std::size_t(1) << this->Bits) - 1);
  }
  this->Entries[2 * entry] = key;
  this->Entries[2 * entry + 1] = static_cast<unsigned int>(layer) |
    static_cast<unsigned int>(std::lround(LargestVisibility * tile.Visibility)) << VisibilityShift;
  this->CoarsestLevel = std::max(this->CoarsestLevel, tile.Tile->Level);
}

bool TerrainTileTable::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->Texture.IsEmpty() && this->Entries == this->Uploaded)
  {
    return true;
  }
  this->Uploaded = this->Entries;
  return this->Texture.Upload(window, this->Entries, 2);
}

void TerrainTileTable::Activate(vtkShaderProgram* program)
{
  this->Texture.Activate(program, "relevoTileTable");
  if (program->IsUniformUsed("relevoTableBits"))
  {
    program->SetUniformi("relevoTableBits", this->Bits);
    program->SetUniformi("relevoCoarsestLevel", this->CoarsestLevel);
  }
}

void TerrainTileTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture.ReleaseGraphicsResources(window);
  this->Uploaded.clear();
}
}

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
// The numbers of relevoTerrainTiles.glsl.
constexpr unsigned int HashFactors[2] = { 2654435769u, 2246822519u };
constexpr int LevelShift = 26;
constexpr float LargestVisibility = 65535.0f;
constexpr std::size_t EntrySize = 4;

std::array<unsigned int, 2> GetTableKey(const TerrainTile& tile)
{
  return { { static_cast<unsigned int>(tile.Column) |
      static_cast<unsigned int>(tile.GetKind()) << 31,
    static_cast<unsigned int>(tile.Row) |
      static_cast<unsigned int>(tile.Level - TerrainTile::FinestLevel + 1) << LevelShift } };
}
}

// At most a quarter of the entries is used, so that searches are short.
void TerrainTileTable::Reset(std::size_t number)
{
  this->Bits = 4;
  while ((std::size_t(1) << this->Bits) < 4 * number)
  {
    ++this->Bits;
  }
  this->Levels.fill({ { TerrainTile::CoarsestLevel, TerrainTile::FinestLevel } });
  this->Entries.assign(EntrySize << this->Bits, 0u);
}

void TerrainTileTable::Add(const MipmapTiles::Item& tile, int layer)
{
  const std::array<unsigned int, 2> key = GetTableKey(*tile.Tile);
  const auto get = [this](std::size_t entry) { return &this->Entries[EntrySize * entry]; };
  std::size_t entry = (key[0] * HashFactors[0] ^ key[1] * HashFactors[1]) >> (32 - this->Bits);
  while (get(entry)[1] != 0u)
  {
    if (std::equal(key.begin(), key.end(), get(entry)))
    {
      return;
    }
    entry = (entry + 1) & ((std::size_t(1) << this->Bits) - 1);
  }
  std::copy(key.begin(), key.end(), get(entry));
  get(entry)[2] = static_cast<unsigned int>(layer);
  get(entry)[3] = static_cast<unsigned int>(std::lround(LargestVisibility * tile.Visibility));
  std::array<int, 2>& levels = this->Levels[static_cast<int>(tile.Tile->GetKind())];
  levels = { { std::min(levels[0], tile.Tile->Level), std::max(levels[1], tile.Tile->Level) } };
}

bool TerrainTileTable::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->Texture.IsEmpty() && this->Entries == this->Uploaded)
  {
    return true;
  }
  this->Uploaded = this->Entries;
  return this->Texture.Upload(window, this->Entries, 4);
}

void TerrainTileTable::Activate(vtkShaderProgram* program)
{
  this->Texture.Activate(program, "relevoTileTable");
  if (program->IsUniformUsed("relevoTableBits"))
  {
    program->SetUniformi("relevoTableBits", this->Bits);
  }
  const auto setLevels = [this, program](const char* name, TerrainTile::Kind kind)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniform2i(name, this->Levels[static_cast<int>(kind)].data());
    }
  };
  setLevels("relevoHeightLevels", TerrainTile::Kind::Heights);
  setLevels("relevoImageryLevels", TerrainTile::Kind::Imagery);
}

void TerrainTileTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture.ReleaseGraphicsResources(window);
  this->Uploaded.clear();
}
}

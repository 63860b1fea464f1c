// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainTileTable
 * @brief   a hash table on the GPU in which fragments find the layers of tiles
 *
 * It is the page table of a virtual texture, with open addressing: an entry has the key of a tile
 * (zeros if it is empty), its layer and its visibility. relevoTerrainTiles.glsl reads it. Private
 * to the module.
 */
#ifndef TerrainTileTable_h
#define TerrainTileTable_h

#include "Bisection/MipmapTiles.h"
#include "Buffers/BufferTexture.h"
#include "vtkType.h" // for numbers of bytes

#include <array>
#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class TerrainTileTable
{
public:
  /// Forget all tiles, and make room for a number of them.
  void Reset(std::size_t number);
  /// Add a tile, unless it is there already.
  void Add(const MipmapTiles::Item& tile, int layer);
  /// Upload the table if it has changed. Return false if it does not fit into graphics memory.
  bool Upload(vtkOpenGLRenderWindow* window);

  /// Bind the table for the shader.
  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Texture.Deactivate(); }
  vtkTypeInt64 GetMemorySize() const { return this->Texture.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  int Bits = 0; // logarithm of the number of entries
  // By kind of tiles: the finest and the coarsest level.
  std::array<std::array<int, 2>, 2> Levels = { { { { 0, 0 } }, { { 0, 0 } } } };
  std::vector<unsigned int> Entries; // 4 per entry
  std::vector<unsigned int> Uploaded;
  BufferTexture Texture;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainTileTextures
 * @brief   tiles on the GPU, in the layers of an array texture
 *
 * A texel of gradients has the differences of the heights to the next column and row, as half
 * floats, by the formula of B. K. P. Horn, "Hill shading and the reflectance map", Proceedings of
 * the IEEE 69(1), 1981.
 *
 * A layer keeps its tile until another tile needs it; the tiles that were used least recently are
 * replaced first. The texture grows to the number of tiles that one frame needs, within a limit.
 * Private to the module.
 */
#ifndef TerrainTileTextures_h
#define TerrainTileTextures_h

#include "Lattice/TerrainTile.h"
#include "vtkType.h" // for numbers of bytes

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace relevo
{
class TerrainTileTextures
{
public:
  /// The bytes of a layer.
  static constexpr vtkTypeInt64 LayerSize =
    static_cast<vtkTypeInt64>(4 * TerrainTile::NumberOfVertices);

  enum class Content
  {
    HEIGHTS,
    GRADIENTS, // of height tiles
    IMAGERY,
    NUMBERS // of another raster
  };

  explicit TerrainTileTextures(Content content);

  /// Change the content. Other content is released.
  void SetContent(Content content);

  /// Set the maximum number of bytes.
  void SetMemoryLimit(vtkTypeInt64 bytes) { this->MemoryLimit = bytes; }

  /// Return the number of different tiles in a list.
  static int CountTiles(const std::vector<const TerrainTile*>& tiles);

  /// Return whether the texture exceeds the limit, so that the next upload makes it smaller.
  bool IsTooLarge() const { return this->GetMemorySize() > this->MemoryLimit; }

  /// Return the number of layers that the current context allows.
  static int GetMaximumNumberOfLayers();

  /**
   * Upload the tiles of a frame that have no layer yet. The list may contain a tile several times.
   * Return false if there are more tiles than layers, or if OpenGL lacks memory.
   */
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<const TerrainTile*>& tiles);

  /// Return the layer of a tile of the last upload.
  int GetLayer(const TerrainTile& tile) const;

  /// Forget the tiles, because their values have changed.
  void Clear() { this->Layers.clear(); }

  //@{
  /// Bind the texture to a sampler of the program, and release its texture unit.
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const char* sampler);
  void Deactivate(vtkOpenGLRenderWindow* window);
  //@}

  vtkTypeInt64 GetMemorySize() const { return this->Capacity * LayerSize; }
  /// Return how many tiles have been uploaded since the object was created.
  vtkIdType GetNumberOfUploads() const { return this->NumberOfUploads; }
  /// Delete the texture. Its context is current.
  void ReleaseGraphicsResources();

private:
  struct Layer
  {
    int Index = 0;
    std::uint64_t LastUse = 0; // frame
  };

  bool Allocate(vtkOpenGLRenderWindow* window, int capacity);
  void UploadTiles(const std::vector<const TerrainTile*>& tiles, const int* layers) const;
  void Bind(vtkOpenGLRenderWindow* window);
  std::vector<int> FindFreeLayers(std::size_t number);

  Content Stored;
  vtkTypeInt64 MemoryLimit = vtkTypeInt64(1) << 28;
  std::unordered_map<std::uint64_t, Layer> Layers; // by key of the tile
  std::uint64_t Frame = 0;
  int Capacity = 0; // layers
  unsigned int Texture = 0;
  int Unit = -1; // texture unit while the texture is bound
  vtkIdType NumberOfUploads = 0;
};
}

#endif

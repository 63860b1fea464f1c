// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainInstances
 * @brief   the faces of a frame, their tiles and their order, on the GPU
 *
 * The faces are grouped by orientation, so that all triangles face up, and by the size of their
 * triangles on the screen. Those at borders, see TerrainBorder, follow without a group. The
 * textures of heights, gradients and imagery share a limit of memory. Private to the module.
 */
#ifndef TerrainInstances_h
#define TerrainInstances_h

#include "Bisection/TerrainFace.h"
#include "Buffers/BufferTexture.h"
#include "Buffers/TerrainTileTable.h"
#include "Buffers/TerrainTileTextures.h"

#include <array>
#include <cstdint>
#include <string> // for errors
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class TerrainInstances
{
public:
  /// Faces of one orientation and size.
  struct Group
  {
    int First = 0;
    int Count = 0;
  };

  /// Return the largest number of faces.
  static vtkIdType GetMaximumNumberOfFaces();

  /// Set the maximum number of bytes of textures of tiles.
  void SetMemoryLimit(vtkTypeInt64 bytes);
  /// Return the number of tiles that the limit and the current context allow.
  int GetMaximumNumberOfTiles() const;
  /// Forget all tiles, because their values have changed.
  void ForgetTiles();
  /// Return how many textures of tiles have been uploaded.
  vtkIdType GetNumberOfTileUploads() const;

  /// The group of a face.
  enum class Kind : std::uint8_t
  {
    Large,
    Small,
    Border
  };

  /**
   * Upload faces, their kinds, their tiles, and those for shading and imagery. Return an error, or
   * "". Nothing is uploaded that has not changed.
   */
  std::string Upload(vtkOpenGLRenderWindow* window, const std::vector<TerrainFace>& faces,
    const std::vector<Kind>& kinds, const std::vector<MipmapTiles::Item>& shading);
  /// Upload the indices of the faces, for selections, after Upload().
  bool UploadIds(vtkOpenGLRenderWindow* window);

  /// Return the faces that have small triangles or not, and whose IsPositive() is true or false.
  const Group& GetGroup(bool isSmall, bool isPositive) const
  {
    return this->Groups[isSmall ? 1 : 0][isPositive ? 1 : 0];
  }
  /// Return the indices of the faces in the order in which they are drawn.
  const std::vector<unsigned int>& GetOrder() const { return this->Ids; }
  int GetNumberOfFaces() const { return static_cast<int>(this->Ids.size()); }

  /// Set whether fragments need heights of the tiles for shading.
  void SetHasHeights(bool hasHeights) { this->HasHeights = hasHeights; }
  /// Set whether imagery has colours or numbers.
  void SetImageryContent(TerrainTileTextures::Content content)
  {
    this->Imagery.SetContent(content);
  }
  /// Return whether there are tiles of imagery.
  bool HasImagery() const { return this->IsImageryUsed; }

  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void Deactivate(vtkOpenGLRenderWindow* window);
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using TileList = std::vector<const TerrainTile*>;

  void AddGroup(const std::vector<TerrainFace>& faces, const std::vector<Kind>& kinds, bool isSmall,
    bool isPositive);
  bool UploadTextures(vtkOpenGLRenderWindow* window, const std::array<TileList, 3>& tiles);
  int GetLayers(const TerrainTile& tile) const;
  std::string UploadTiles(vtkOpenGLRenderWindow* window, const std::vector<TerrainFace>& faces,
    const std::vector<MipmapTiles::Item>& shading);

  TerrainTileTextures Tiles{ TerrainTileTextures::Content::HEIGHTS };
  TerrainTileTextures Gradients{ TerrainTileTextures::Content::GRADIENTS };
  TerrainTileTextures Imagery{ TerrainTileTextures::Content::IMAGERY };
  std::array<int, 3> MaximumNumbers = { { 0, 0, 0 } }; // of tiles of these textures
  vtkTypeInt64 MemoryLimit = vtkTypeInt64(1) << 28;
  bool IsImageryUsed = false;
  bool HasHeights = false;
  TerrainTileTable Table; // of gradients, heights and imagery
  Group Groups[2][2];
  std::vector<unsigned int> Integers; // 4 per face
  std::vector<float> Floats;          // 4 per face
  std::vector<unsigned int> Ids;
  BufferTexture IntegerTexture;
  BufferTexture FloatTexture;
  BufferTexture IdTexture;
};
}

#endif

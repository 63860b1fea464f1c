// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainInstances
 * @brief   the faces of a frame, their tiles and their order, on the GPU
 *
 * The faces are grouped by orientation, so that all triangles face up. Private to the module.
 */
#ifndef TerrainInstances_h
#define TerrainInstances_h

#include "Bisection/TerrainFace.h"
#include "Buffers/BufferTexture.h"
#include "Buffers/TerrainTileTextures.h"

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
  /// Faces of one orientation.
  struct Group
  {
    int First = 0;
    int Count = 0;
  };

  /// Return the largest number of faces.
  static vtkIdType GetMaximumNumberOfFaces();

  //@{
  /// The tiles of TerrainTileTextures.
  TerrainTileTextures& GetTiles() { return this->Tiles; }
  const TerrainTileTextures& GetTiles() const { return this->Tiles; }
  //@}

  /**
   * Upload faces and their tiles. Return an error, or "". Nothing is uploaded that has not changed.
   */
  std::string Upload(vtkOpenGLRenderWindow* window, const std::vector<TerrainFace>& faces);
  /// Upload the indices of the faces, for selections, after Upload().
  bool UploadIds(vtkOpenGLRenderWindow* window);

  /// Return the faces whose IsPositive() is true or false.
  const Group& GetGroup(bool isPositive) const { return this->Groups[isPositive ? 1 : 0]; }
  int GetNumberOfFaces() const { return this->Groups[0].Count + this->Groups[1].Count; }

  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void Deactivate(vtkOpenGLRenderWindow* window);
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  TerrainTileTextures Tiles{ TerrainTile::Kind::Heights };
  Group Groups[2];
  std::vector<unsigned int> Integers; // 4 per face
  std::vector<float> Floats;          // 4 per face
  std::vector<unsigned int> Ids;
  BufferTexture IntegerTexture;
  BufferTexture FloatTexture;
  BufferTexture IdTexture;
};
}

#endif

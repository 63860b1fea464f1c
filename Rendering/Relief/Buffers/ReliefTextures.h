// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefTextures
 * @brief   the tiles of a relief on the graphics card
 *
 * Private to the module.
 */
#ifndef ReliefTextures_h
#define ReliefTextures_h

#include "Buffers/BufferTexture.h"
#include "vtkSmartPointer.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class ReliefTiles;

class ReliefTextures
{
public:
  /// The largest number of texels along a side of this context's textures.
  static int GetLargestSize();

  /// false where OpenGL does not have room for them.
  bool Upload(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);

  /// The cones of MakeReliefCones(), too.
  bool UploadCones(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);
  /// And the grid of tiles, for shadows.
  bool UploadGrid(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);
  bool HasGrid() const { return !this->Grid.IsEmpty(); }
  bool HasCones() const { return this->Cones != nullptr; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  int GetNumberOfTiles() const { return this->NumberOfTiles; }
  bool HasNormals() const { return this->Normals != nullptr; }
  /// Bytes.
  vtkTypeInt64 GetMemorySize() const;

private:
  BufferTexture Places;
  BufferTexture Quads;
  BufferTexture Ranges;
  BufferTexture Grid;
  vtkSmartPointer<vtkTextureObject> Heights;
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkSmartPointer<vtkTextureObject> Normals;
  vtkSmartPointer<vtkTextureObject> Cones;
  int NumberOfTiles = 0;
  int TilesPerRow = 1;
  vtkTypeInt64 TextureMemory = 0;
};
}

#endif

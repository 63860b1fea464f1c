// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefTextures
 * @brief   the tiles of a relief on the GPU
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
  /// Return the largest size of this context's textures, in texels.
  static int GetLargestSize();

  /// Upload the tiles. Return false if OpenGL lacks memory.
  bool Upload(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);

  /// Upload the cones of MakeReliefCones().
  bool UploadCones(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);
  /// Upload the grid of tiles, for shadows.
  bool UploadGrid(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);
  bool HasGrid() const { return !this->Grid.IsEmpty(); }
  bool HasCones() const { return this->Cones != nullptr; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  int GetNumberOfTiles() const { return this->NumberOfTiles; }
  bool HasNormals() const { return this->Normals != nullptr; }
  /// Return the number of bytes.
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

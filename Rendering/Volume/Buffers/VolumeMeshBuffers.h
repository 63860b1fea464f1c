// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeMeshBuffers
 * @brief   a RayCastMesh on the GPU
 *
 * Private to the module.
 */
#ifndef VolumeMeshBuffers_h
#define VolumeMeshBuffers_h

#include "Buffers/BufferTexture.h"

#include <array>
#include <cstddef>

namespace relevo
{
struct RayCastMesh;

class VolumeMeshBuffers
{
public:
  /// Upload a mesh. Return false if it does not fit into the buffer textures of this OpenGL.
  bool Upload(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh);

  /// Upload the points, scalars and gradients of a mesh that has been uploaded. Return false if the
  /// upload fails.
  bool UploadScalars(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh);

  /// Read sums, neighbours, curved cells and border faces of the mesh that has been uploaded.
  void Download(RayCastMesh& mesh);

  /// Upload the corners of tetrahedra, unless the mesh has them. They are found from the neighbours
  /// on the graphics card. Return false if that is not possible.
  bool AddCorners(vtkOpenGLRenderWindow* window);

  /// Activate the textures, and set their samplers and sizes.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  int GetNumberOfBorderFaces() const { return this->NumberOfBorderFaces; }
  size_t GetNumberOfCells() const { return this->NumberOfCells; }
  /// Return the number of uploads of meshes and scalars.
  vtkIdType GetNumberOfUploads() const { return this->NumberOfUploads; }

  /// Return the number of bytes.
  vtkTypeInt64 GetMemorySize() const;

private:
  enum Kinds
  {
    Points,
    PointScalars,
    CellScalars,
    CornerScalars,
    PointGradients,
    PointSums,
    Corners, // of tetrahedra, if points at one place have different scalars, or on request
    Neighbors,
    CurvedCells,
    BorderFaces,
    BorderTree,
    NumberOfKinds
  };
  enum class CornerState
  {
    Unknown,
    Missing, // cannot be found
    Uploaded
  };
  bool FindCorners(vtkOpenGLRenderWindow* window);

  std::array<BufferTexture, NumberOfKinds> Buffers;
  CornerState HasCorners = CornerState::Unknown;
  vtkIdType NumberOfUploads = 0;
  size_t NumberOfCells = 0;
  int TreeSize = 0;
  int NumberOfBorderFaces = 0;
  int MaximumSteps = 0;
  int NumberOfTetrahedra = 0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementMeshBuffers
 * @brief   a prepared coarse mesh on the GPU
 */
#ifndef RefinementMeshBuffers_h
#define RefinementMeshBuffers_h

#include "Buffers/BufferTexture.h"

#include "vtkType.h" // for sizes

#include <array>  // for GetBuffers
#include <map>    // for members
#include <memory> // for members
#include <string> // for errors
#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObject;
class vtkOpenGLVertexBufferObjectGroup;
class vtkRefinementSurface;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class RefinementMesh;
struct RefinementShaderOptions;

class RefinementMeshBuffers
{
public:
  RefinementMeshBuffers();
  ~RefinementMeshBuffers();
  RefinementMeshBuffers(const RefinementMeshBuffers&) = delete;
  void operator=(const RefinementMeshBuffers&) = delete;

  /**
   * Upload the mesh, prepared for the surface (nullptr for none), but for its faces. `positions` is
   * VTK's vertexMC, whose shift and scale the surface's vectors must share. False, with GetError(),
   * when the GPU cannot hold it.
   */
  bool UploadMesh(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    vtkRefinementSurface* surface, vtkOpenGLVertexBufferObject* positions);

  /**
   * Take the mesh's faces of a representation (see vtkProperty). False when they have not been
   * uploaded since the mesh was.
   */
  bool UseFaces(int representation);

  /**
   * Upload the mesh's faces of a representation, and take them. `primitives` gives, per face, the
   * id that VTK would have drawn it with. False, with GetError(), when the GPU cannot hold them.
   */
  bool UploadFaces(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    const std::vector<int>& primitives, int representation);

  /// OpenGL's name of the faces' buffer; 0 for none.
  unsigned int GetFaces() const { return this->Faces ? this->Faces->GetHandle() : 0; }

  /// Alias VTK's vertex buffers for the attributes that the refining shaders read.
  bool AliasAttributes(vtkOpenGLRenderWindow* window, vtkOpenGLVertexBufferObjectGroup* vbos,
    const std::vector<std::string>& attributes);

  /// Fill in what the shaders depend on.
  void FillOptions(const RefinementMesh& mesh, RefinementShaderOptions& options) const;

  void Activate(vtkShaderProgram* program);
  void Deactivate();

  /// Set the uniforms that change live.
  void SetUniforms(vtkShaderProgram* program, vtkAdaptiveRefinement* recipe) const;

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetError() const { return this->Error; }

private:
  std::map<int, BufferTexture> FacesOfRepresentations;
  BufferTexture* Faces = nullptr; // one of them
  BufferTexture Points;
  BufferTexture PointData;
  BufferTexture Vectors;
  BufferTexture Seams;
  BufferTexture TableEntries;
  BufferTexture TableRecords;
  BufferTexture TablePoints;
  std::map<std::string, std::unique_ptr<BufferTexture>> Attributes;
  void ReleaseFaces(vtkWindow* window);
  bool UploadPointData(
    vtkOpenGLRenderWindow* window, const RefinementMesh& mesh, vtkRefinementSurface* surface);
  bool UploadVectors(
    vtkOpenGLRenderWindow* window, const RefinementMesh& mesh, vtkRefinementSurface* surface);
  bool UploadSeams(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh);
  bool UploadTables(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh);
  /// What the faces share, whichever representation they are drawn in.
  std::array<BufferTexture*, 7> GetBuffers();
  float GetVertexCoordinate(const RefinementMesh& mesh, float x, size_t axis) const;

  // Of VTK's vertexMC: (p - shift) * scale.
  double PositionShift[3] = { 0.0, 0.0, 0.0 };
  double PositionScale[3] = { 1.0, 1.0, 1.0 };
  int ShaderValues = 0;
  std::string Error;
};
}

#endif

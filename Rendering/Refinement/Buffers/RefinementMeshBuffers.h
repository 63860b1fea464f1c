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
   * Upload the mesh, prepared for the surface (or nullptr), without its faces. `positions` is VTK's
   * vertexMC; the surface's vectors must use its shift and scale. Return false and set GetError()
   * if the GPU cannot hold the mesh.
   */
  bool UploadMesh(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    vtkRefinementSurface* surface, vtkOpenGLVertexBufferObject* positions);

  /**
   * Use the mesh's faces of a representation (see vtkProperty). Return false if they have not been
   * uploaded since the mesh was.
   */
  bool UseFaces(int representation);

  /**
   * Upload and use the mesh's faces of a representation. `primitives` contains, per face, VTK's
   * primitive id. Return false and set GetError() if the GPU cannot hold them.
   */
  bool UploadFaces(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    const std::vector<int>& primitives, int representation);

  /// Return OpenGL's name of the faces' buffer; 0 for none.
  unsigned int GetFaces() const { return this->Faces ? this->Faces->GetHandle() : 0; }

  /// Alias VTK's vertex buffers for the attributes that the refining shaders read.
  bool AliasAttributes(vtkOpenGLRenderWindow* window, vtkOpenGLVertexBufferObjectGroup* vbos,
    const std::vector<std::string>& attributes);

  /// Set the options that depend on the mesh.
  void FillOptions(const RefinementMesh& mesh, RefinementShaderOptions& options) const;

  void Activate(vtkShaderProgram* program);
  void Deactivate();

  /// Set the uniforms that change without a rebuild.
  void SetUniforms(vtkShaderProgram* program, vtkAdaptiveRefinement* recipe) const;

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetError() const { return this->Error; }

private:
  std::map<int, BufferTexture> FacesOfRepresentations;
  BufferTexture* Faces = nullptr; // one of the members below
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
  /// Return the buffers that all representations share.
  std::array<BufferTexture*, 7> GetBuffers();
  float GetVertexCoordinate(const RefinementMesh& mesh, float x, size_t axis) const;

  // The shift and scale of VTK's vertexMC: (p - shift) * scale.
  double PositionShift[3] = { 0.0, 0.0, 0.0 };
  double PositionScale[3] = { 1.0, 1.0, 1.0 };
  int ShaderValues = 0;
  std::string Error;
};
}

#endif

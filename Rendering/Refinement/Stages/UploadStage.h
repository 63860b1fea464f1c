// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   UploadStage
 * @brief   what a mapper has on the GPU of its mesh, its height map and the faces that it draws
 *
 * Everything stays there until something that it was made from changes. Private to the module.
 */
#ifndef UploadStage_h
#define UploadStage_h

#include "Buffers/HeightTextures.h"          // for members
#include "Buffers/InstanceBuffers.h"         // for members
#include "Buffers/RefinementMeshBuffers.h"   // for members
#include "Buffers/RefinementPatternBuffer.h" // for members
#include "Buffers/VertexColors.h"            // for members
#include "Changes/Dependencies.h"            // for members
#include "Compute/RefinementComputeState.h"  // for Targets
#include "Stages/StageResult.h"
#include "vtkTimeStamp.h" // for members

#include <map>    // for members
#include <string> // for members
#include <vector> // for attributes

class vtkAbstractArray;
class vtkAdaptiveRefinement;
class vtkOpenGLCellToVTKCellMap;
class vtkOpenGLVertexBufferObject;
class vtkOpenGLVertexBufferObjectGroup;
class vtkScalarsToColors;

namespace relevo
{
class MethodStage;
struct RefinementDrawing;

class UploadStage
{
public:
  /// A mesh, and what VTK's mapper has uploaded of it.
  struct MeshInput
  {
    vtkOpenGLRenderWindow* Window;
    /// nullptr where it is not valid.
    const RefinementMesh* Mesh;
    vtkMTimeType MeshTime;
    /// Of the mapper's settings that VTK's buffers depend on.
    vtkMTimeType BuildTime;
    /// VTK's vertexMC; nullptr for none.
    vtkOpenGLVertexBufferObject* Positions;
    vtkAdaptiveRefinement* Recipe;
    /// Scalars of points that colours are interpolated by; nullptr for none. For the rest see
    /// VertexColors.
    vtkAbstractArray* Scalars;
    vtkScalarsToColors* Table;
    int Component;
    bool ByTexture;
    /// See vtkProperty.
    int Representation;
    vtkIdType NumberOfCells;
    /// Of this representation.
    vtkOpenGLCellToVTKCellMap* CellMap;
  };

  /**
   * Whether UploadMesh() is to be called although VTK's own buffers are up to date.
   */
  bool NeedsMesh(
    vtkMTimeType meshTime, vtkMTimeType buildTime, vtkOpenGLVertexBufferObject* positions) const;

  /**
   * Upload what has changed of the mesh, after VTK has uploaded its own buffers.
   */
  StageResult UploadMesh(const MeshInput& input);
  bool IsMeshValid() const { return this->Valid; }

  /// Upload the heights of a displacement, or none for nullptr, if they have changed.
  StageResult UploadHeights(vtkOpenGLRenderWindow* window, vtkDisplacement* displacement);

  /**
   * Upload the faces that are drawn and what the method in use takes. Falls back to the default
   * method if the GPU cannot hold that.
   */
  StageResult UploadSelection(MethodStage& methods, const RefinementDrawing& drawing);
  /// Try again what this method has failed to upload.
  void ForgetFailures(int method);

  RefinementPatternBuffer& GetPatterns() { return this->Patterns; }
  InstanceBuffers& GetInstances() { return this->Instances; }
  const VertexColors& GetColors() const { return this->Colors; }
  /// The buffers that compute shaders draw from and write to.
  RefinementComputeState::Targets GetTargets() const;

  /// Fill in what the shaders depend on.
  void FillOptions(const RefinementMesh& mesh, RefinementShaderOptions& options) const;

  /**
   * Have a program read the buffers, and VTK's for the attributes that refining shaders read from
   * them; with the uniforms that change live.
   */
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
    vtkOpenGLVertexBufferObjectGroup* vbos, const std::vector<std::string>& attributes,
    vtkAdaptiveRefinement* recipe);
  void Deactivate();

  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool UploadPoints(const MeshInput& input);
  bool UploadFaces(const MeshInput& input);

  RefinementMeshBuffers Buffers;
  HeightTextures Heights;
  VertexColors Colors;
  RefinementPatternBuffer Patterns;
  InstanceBuffers Instances;

  vtkTimeStamp UploadTime;
  Dependencies UploadDependencies;
  bool Valid = false;
  std::string HeightError; // that was reported last
  /// By method and by view: what could not be uploaded. It is not tried again.
  std::map<int, std::map<int, Dependencies>> FailedUploads;
  vtkIdType NumberOfBuilds = 0;
};
}

#endif

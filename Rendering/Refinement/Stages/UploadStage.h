// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   UploadStage
 * @brief   the GPU buffers of a mapper's mesh, height map and drawn faces
 *
 * Each is uploaded again only when its dependencies change. Private to the module.
 */
#ifndef UploadStage_h
#define UploadStage_h

#include "Buffers/HeightTextures.h"          // for members
#include "Buffers/InstanceBuffers.h"         // for members
#include "Buffers/RefinementField.h"         // for members
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
class vtkPolyData;
class vtkScalarsToColors;

namespace relevo
{
class MethodStage;
struct RefinementDrawing;

class UploadStage
{
public:
  /// A mesh, and the buffers of VTK's mapper.
  struct MeshInput
  {
    vtkOpenGLRenderWindow* Window;
    /// nullptr if the mesh is not valid.
    const RefinementMesh* Mesh;
    vtkMTimeType MeshTime;
    /// The modification time of the settings that VTK's buffers depend on, without the lookup table
    /// of the scalars.
    vtkMTimeType BuildTime;
    /// The same with the lookup table.
    vtkMTimeType ColorTime;
    /// VTK's vertexMC, or nullptr.
    vtkOpenGLVertexBufferObject* Positions;
    vtkAdaptiveRefinement* Recipe;
    vtkPolyData* Input;
    /// Point scalars that are mapped to colours, or are colours; nullptr for none. For the other
    /// members see VertexColors.
    vtkAbstractArray* Scalars;
    /// The same for scalars of cells.
    vtkAbstractArray* CellScalars;
    bool AreColors;
    vtkScalarsToColors* Table;
    int Component;
    bool ByTexture;
    /// See vtkProperty.
    int Representation;
    vtkIdType NumberOfCells;
    /// The cell map of this representation.
    vtkOpenGLCellToVTKCellMap* CellMap;
  };

  /**
   * Return whether to call UploadMesh() although VTK's buffers are up to date.
   */
  bool NeedsMesh(
    vtkMTimeType meshTime, vtkMTimeType buildTime, vtkOpenGLVertexBufferObject* positions) const;

  /**
   * Upload the parts of the mesh that have changed, after VTK has uploaded its buffers.
   */
  StageResult UploadMesh(const MeshInput& input);
  bool IsMeshValid() const { return this->Valid; }

  /// Upload the heights of a displacement if they have changed; nullptr has no heights.
  StageResult UploadHeights(vtkOpenGLRenderWindow* window, vtkDisplacement* displacement);

  /**
   * Upload the drawn faces and the data of the current method. If the GPU cannot hold them, the
   * default method is used.
   */
  StageResult UploadSelection(MethodStage& methods, const RefinementDrawing& drawing);
  /// Try failed uploads of this method again.
  void ForgetFailures(int method);

  RefinementPatternBuffer& GetPatterns() { return this->Patterns; }
  InstanceBuffers& GetInstances() { return this->Instances; }
  const VertexColors& GetColors() const { return this->Colors; }
  const RefinementField& GetField() const { return this->Field; }
  /// Return the buffers that compute shaders read and write.
  RefinementComputeState::Targets GetTargets() const;

  /// Set the options that depend on the buffers.
  void FillOptions(const RefinementMesh& mesh, RefinementShaderOptions& options) const;

  /**
   * Bind the buffers to a program, VTK's buffers for the attributes that refining shaders read from
   * them, and set the uniforms that change without a rebuild.
   */
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
    vtkOpenGLVertexBufferObjectGroup* vbos, const std::vector<std::string>& attributes,
    vtkAdaptiveRefinement* recipe);
  void Deactivate();

  /// Return how often the mesh, its scalars or both were uploaded.
  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool UploadPoints(const MeshInput& input);
  void UploadColors(const MeshInput& input);
  vtkIdType GetNumberOfScalarUploads() const;
  bool UploadFaces(const MeshInput& input);

  RefinementMeshBuffers Buffers;
  HeightTextures Heights;
  VertexColors Colors;
  RefinementField Field;
  RefinementPatternBuffer Patterns;
  InstanceBuffers Instances;

  vtkTimeStamp UploadTime;
  Dependencies UploadDependencies;
  Dependencies ColorDependencies;
  bool Valid = false;
  std::string MeshError; // errors that were reported last
  std::string HeightError;
  /// Failed uploads by method and by view. They are not tried again.
  std::map<int, std::map<int, Dependencies>> FailedUploads;
  vtkIdType NumberOfBuilds = 0;
};
}

#endif

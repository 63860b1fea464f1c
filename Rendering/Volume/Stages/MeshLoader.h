// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshLoader
 * @brief   the stage that reads the cells and scalars of an input and uploads them
 *
 * Private to the module.
 */
#ifndef MeshLoader_h
#define MeshLoader_h

#include "Buffers/ProjectedCells.h"
#include "Buffers/VolumeMeshBuffers.h"
#include "Cells/ScalarChoice.h"
#include "Changes/Dependencies.h"
#include "Checks/StageReport.h"
#include "Mesh/MeshValues.h"
#include "Mesh/RayCastMesh.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace relevo
{
class VolumeCells;
struct MeshScalars;

struct MeshRequest
{
  vtkOpenGLRenderWindow* Window;
  vtkDataObject* Input;
  vtkInformation* Port; // types that the input may have
  ScalarChoice Choice;
  //@{
  /// The settings of vtkAbstractMapper; the name may be empty.
  int ScalarMode;
  int ArrayAccessMode;
  int ArrayId;
  std::string ArrayName;
  //@}
  bool AreIndependent; // whether components are independent
  bool IsShaded;
  bool HasCorners;                   // for cell projection
  double ShapeTolerance;             // share of the mesh's diagonal
  double FieldTolerance;             // share of the range of scalars
  bool KeepsHostData;                // to replace values
  bool HasSurfaces;                  // isosurfaces, which need values at points
  double LevelOfDetail;              // share of the cells of a simplified mesh; 0 for none
  const MeshExtent* Whole = nullptr; // if the input is a piece of a mesh
};

/// The mesh on the GPU.
struct VolumeMesh
{
  RayCastMesh Layout; // without its arrays
  VolumeMeshBuffers Buffers;
  ProjectedCells Cells; // only with corners
  int NumberOfComponents = 1;
  bool HasCellScalars = false;
  bool HasTetrahedra = false;
  bool HasCurvedCells = false;
  bool HasTangledCells = false;
};

class MeshLoader
{
public:
  MeshLoader();
  ~MeshLoader();

  /// Load the mesh if the request has changed. Return whether there is anything to draw. A failed
  /// load is repeated and reported again when the request changes. If only values have changed,
  /// only they are uploaded.
  bool Update(const MeshRequest& request, StageReport& report);

  /// Return the extent of the input's cells; it is empty if there are none or they cannot be read.
  /// The cells stay in memory until they are loaded.
  MeshExtent Measure(const MeshRequest& request, StageReport& report);

  bool IsReady() const { return this->HasMesh && this->NumberOfDrawnCells > 0; }
  VolumeMesh& GetMesh() { return this->Mesh; }
  const VolumeMesh& GetMesh() const { return this->Mesh; }
  vtkIdType GetNumberOfDrawnCells() const { return this->NumberOfDrawnCells; }
  /// Return the number of uploads, and of those that replaced only values.
  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  vtkIdType GetNumberOfValueUploads() const { return this->NumberOfValueUploads; }
  /// Return the number of uploads that did not take the neighbours of the mesh before.
  vtkIdType GetNumberOfNeighborSearches() const { return this->NumberOfNeighborSearches; }

  /// Return the cells of the last load, once, for a simplified mesh with one component. Return null
  /// if there are none.
  std::unique_ptr<VolumeCells> TakeCells();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  Dependencies FindDependencies(const MeshRequest& request) const;
  bool Load(const MeshRequest& request, StageReport& report);
  bool LoadMeasured(const MeshRequest& request, StageReport& report);
  bool CheckType(const MeshRequest& request, StageReport& report);
  bool FindScalars(const MeshRequest& request, StageReport& report,
    std::vector<MeshScalars>& meshes, std::string& leftOut);
  ScalarChoice FindChoice(const MeshRequest& request, vtkDataArray* array) const;
  bool Read(const MeshRequest& request, VolumeCells& cells, std::vector<MeshScalars>& meshes,
    StageReport& report);
  bool Upload(const MeshRequest& request, VolumeCells& cells, StageReport& report);
  void SplitCurved(
    const MeshRequest& request, bool isNew, VolumeCells& cells, StageReport& report) const;
  bool ReadCells(RayCastMesh& mesh);
  bool ReplaceValues(const MeshRequest& request, StageReport& report);

  VolumeMesh Mesh;
  Dependencies Known;
  Dependencies Measured;
  MeshExtent Extent;                   // measured
  std::unique_ptr<VolumeCells> Cells;  // measured, but not loaded
  std::unique_ptr<VolumeCells> Loaded; // for a simplified mesh
  MeshValues Values;                   // of the mesh, if they can be replaced
  std::string Signature;               // of the mesh, if values can be replaced
  MeshExtent Whole;                    // in use, if
  bool IsPiece = false;                // the mesh is a piece
  bool HasMesh = false;
  bool HasGradients = false; // as in the last build, whether or not scalars allow them
  vtkIdType NumberOfDrawnCells = 0;
  vtkIdType NumberOfBuilds = 0;
  vtkIdType NumberOfValueUploads = 0;
  vtkIdType NumberOfNeighborSearches = 0;
  bool IsUploaded = false; // whether the buffers have a mesh
  bool HasCorners = false; // of the mesh in the buffers

  /// The mesh whose cells have been reported. Settings that rebuild it do not repeat the report.
  Dependencies Reported;
  std::string LeftOut;     // ignored blocks, as reported
  bool AreOfCells = false; // whether the arrays of the input are
  std::string Averaged;    // at points, as found
  std::string ReportedAverages;
  std::string MissingValues;             // as reported
  vtkDataObject* CheckedInput = nullptr; // not dereferenced
  std::string TypeError;                 // as reported
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshScene
 * @brief   a mesh with a surface, optionally displaced by a height map, coloured by an array or a
 * picture
 */
#ifndef MeshScene_h
#define MeshScene_h

#include "Scene/CutPlane.h"
#include "Scene/PictureMarks.h"
#include "Scene/SurfaceScene.h"

#include "vtkSmartPointer.h"

#include <string>

class IntegrationPointActor;
class MeshProbe;
class MeshReader;
class MeshSection;
class StreamlineActor;
class TimeSteps;
class vtkDataArray;
class vtkDataSet;
class vtkDisplacement;
class vtkScalarsToColors;

class MeshScene : public SurfaceScene
{
public:
  /// Reads the files. Throws ViewerError.
  MeshScene(const ViewerOptions& options, ViewerMessages& messages);
  ~MeshScene() override;

  /// Prints on stdout: the surface, if the options leave it open and it is not the mesh's shape,
  /// and the arrays of a mesh drawn without one.
  void Report() override;
  std::string Describe(const double point[3], double resolution) override;
  int GetNumberOfTimeSteps() override;
  void SetTimeStep(int step) override;
  std::string Change(char key) override;
  void ResetView() override;
  SceneContent GetContent() override;

private:
  void AddDataCode(SceneCode& code) override;
  OptionNames GetUpdatedOptions() override;
  bool ApplyOptions(const OptionNames& changed) override;
  void ApplyStep(bool isOtherTime);
  bool ApplyCut();
  /// The surface and hair that the view must show.
  vtkSmartPointer<vtkPolyData> GetSeen();
  void SetDisplacement();
  /// Reads the current time step again and shows it.
  void Reload();
  /// Reads the current time step into Mesh. Returns whether it is a surface of cells.
  bool ReadStep();
  void TakePatches();
  void TakeMicroMesh();
  // Encode the time step that is shown, or those that the file's name asks for. Return the last.
  vtkSmartPointer<vtkPolyData> EncodeStep(const std::string& file);
  vtkSmartPointer<vtkPolyData> EncodeSteps();
  void ChooseSurface(bool isOfCells);
  void FindCreases();
  /// Finishes the mesh after its surface has been chosen.
  void CompleteMesh();
  void ReadHeights();
  /// Prints a scale on stdout if the warp is too small to be seen.
  void ReportWarp();
  void ChooseArray();
  void ChooseVectors();
  /// Whether refinement would not change the picture and is not requested.
  bool IsAsItIs() const;
  int GetDefaultLevel() override;
  vtkSmartPointer<vtkDepthTagMetric> MakeSceneMetric() override;
  void SetColours();
  void SetArrayColours();
  bool IsColouredByArray() const;
  /// Extends the range of the colours by that of the current step, unless the options set it.
  void ExtendRange();
  void ExtendRangeByAllSteps();
  /// Extends a range by the values inside of the mesh, which a cut shows.
  void AddRangeOfCells(std::array<double, 2>& range);
  void UpdateColours();
  vtkDataArray* GetArray();
  /// Returns the visible cell at a point, or -1, and the values of the array there.
  vtkIdType FindCell(const double point[3], double resolution, std::vector<double>& values);
  std::optional<std::array<double, 3>> GetCentre();
  vtkSmartPointer<vtkPolyData> GetSurface();
  /// Clips the surface at the plane and fills the section of solid cells.
  void AddSection();
  std::string MoveCut(char key);
  void ShowIsolinesOfSection();
  /// Whether the mesh has 3D cells.
  bool IsSolid() const;
  /// Traces the streamlines of the options through the current step.
  void ShowStreamlines();
  /// Shows the integration points of the current step if the options request them.
  void ShowIntegrationPoints();
  /// Labels the largest and the smallest visible value if the options request it.
  void ShowExtremes();

  vtkNew<vtkDisplacement> Displacement;
  std::unique_ptr<TimeSteps> Steps;
  std::unique_ptr<MeshReader> Reader; // of the steps
  bool HasCreases = false;            // whether normals are from creases
  std::string MicroMeshReport;        // empty without a micro-mesh
  std::string CurvedBy;               // the reason for the surface, for Report()
  const std::string GivenArray;       // by the options: an array, or a quantity of one
  // The array that colours the mesh, or an empty string, and whether it is a point array.
  std::string ArrayName;
  bool HasPointArray = false;
  vtkSmartPointer<vtkScalarsToColors> Colours; // of the array
  std::optional<std::array<double, 2>> Range;  // of the colours
  std::unique_ptr<MeshProbe> Probe;            // created at the first query
  vtkSmartPointer<vtkActor> Hair;              // nullptr without hair
  PictureMarks Extremes;
  CutPlane Cut;
  vtkSmartPointer<vtkDataSet> Cells; // the mesh that the surface bounds
  bool IsOfCells = false;            // whether Cells is not the surface itself
  std::unique_ptr<MeshSection> Section;
  std::unique_ptr<StreamlineActor> Streamlines;             // nullptr for none
  std::unique_ptr<IntegrationPointActor> IntegrationPoints; // nullptr for none
  // Vectors of the streaks, or nullptr.
  vtkSmartPointer<vtkDataArray> Vectors;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidScene
 * @brief   a height map of any size, drawn from tiles that are read when the view needs them
 */
#ifndef PyramidScene_h
#define PyramidScene_h

#include "Scene/ViewerScene.h"

#include "vtkSmartPointer.h"

class GlobeCamera;
class PyramidGround;
class TerrainCamera;
class vtkActor;
class vtkColorTransferFunction;
class vtkTerrainMapper;
class vtkTerrainPyramid;

class PyramidScene : public ViewerScene
{
public:
  /// Opens the raster. Returns nullptr if TerrainScene must read it, or explain why it cannot be
  /// read. Throws ViewerError.
  static std::unique_ptr<PyramidScene> Open(const ViewerOptions& options, ViewerMessages& messages);
  ~PyramidScene() override;

  std::string GetUnit() override;
  std::string Describe(const double point[3], double resolution) override;
  void Export(const std::string& fileName) override;
  void Report() override;
  void Draw(vtkRenderWindow* window) override;
  std::optional<int> GetFrameDelay() override;
  void CheckFlight(const std::vector<FlightPosition>& positions) override;
  void LookFrom(const FlightPosition& position) override;
  void CheckPictures() override;
  void ResetView() override;
  SceneContent GetContent() override;
  SceneFigures GetFigures() override;

private:
  void AddDataCode(SceneCode&) override {} // the mapper reads the raster
  OptionNames GetUpdatedOptions() override;
  bool ApplyOptions(const OptionNames& changed) override;
  PyramidScene(const ViewerOptions& options, ViewerMessages& messages, vtkTerrainPyramid* pyramid);

  /// Whether there are heights that can be drawn. Waits for the index if the picture needs it.
  bool HasTerrain();
  void Show();
  void SetBase();
  void ChooseExaggeration();
  void WarnOfData();
  void SetColours();
  void UpdateColours();
  /// Colours of heights above the sea level. Sets the water below it.
  vtkSmartPointer<vtkColorTransferFunction> MakeColoursOfHeights();
  void SetCamera();
  /// Sets camera and lights around a place on the globe.
  void SetGlobeCamera();
  /// A point, and the directions east, north and up there. Returns false if it has no coordinates.
  bool FindDirections(const std::array<double, 3>& geographic, std::array<double, 3>& place,
    std::array<std::array<double, 3>, 3>& directions);
  void PrintStatistics(vtkRenderWindow* window);

  vtkSmartPointer<vtkTerrainPyramid> Pyramid;
  vtkNew<vtkTerrainMapper> Mapper;
  vtkNew<vtkActor> Actor;
  std::unique_ptr<PyramidGround> Ground;
  vtkSmartPointer<vtkColorTransferFunction> Colours;
  TerrainCamera* GroundCamera = nullptr; // this->Camera, if the world is a map
  GlobeCamera* EarthCamera = nullptr;    // this->Camera, if it is a globe
  std::string ExaggeratedBy;             // reason for the exaggeration, for the report
  bool IsSmall = false;                  // read at once
  bool HasEstimates = false;             // in the range of the colours
  bool HasMore = false;                  // whether another frame would show more
  int NumberOfPictures = 0;
  int NumberOfEmptyPictures = 0;
  double LargestError = 0.0; // of all pictures, in pixels
  double LastError = 0.0;
  long long LastMemory = 0;
};

#endif

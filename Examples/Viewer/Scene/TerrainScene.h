// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainScene
 * @brief   a height map, with its imagery or in the colours of its heights
 */
#ifndef TerrainScene_h
#define TerrainScene_h

#include "Scene/SurfaceScene.h"

#include "vtkSmartPointer.h"

class TerrainProbe;
class vtkTerrainSource;

class TerrainScene : public SurfaceScene
{
public:
  /// Reads the files; throws ViewerError.
  TerrainScene(const ViewerOptions& options, ViewerMessages& messages);
  ~TerrainScene() override;

  std::string GetUnit() override;
  std::string Describe(const double point[3], double resolution) override;
  void Report() override;

private:
  void AddExportedData(vtkPolyData* mesh) override;
  void ReadTerrain();
  void CheckReading();
  std::string ExplainReading(const std::string& text);
  void CheckExaggeration();
  /// Heights and coordinates of different kinds, such as grey levels over texels, need a factor.
  void ChooseExaggeration(double heights, double width);
  /// Whether coordinates count texels: there is no georeference.
  bool CountsTexels();
  void CheckBudget();
  /// The raster's heights, in its unit, at the mesh's texture coordinates.
  void AddHeights(vtkPolyData* mesh);
  void MakeDisplacedMesh();
  void KeepAboveGround();
  int GetDefaultLevel();
  vtkSmartPointer<vtkDepthTagMetric> MakeReliefMetric();
  void SetColours();
  /// Of the raster's heights; "" where it is not known.
  std::string GetHeightUnit();
  std::optional<std::array<double, 3>> GetCentre();
  /// Whether numbers for --center look like a longitude and a latitude.
  bool IsInRaster(double longitude, double latitude);
  std::array<double, 3> FindDegrees(const std::array<double, 2>& degrees);
  std::array<double, 3> FindGround(double x, double y, const std::string& text);

  vtkNew<vtkTerrainSource> Source;
  // The coarse mesh as the displacement moves it: what the camera and the metrics look at.
  vtkNew<vtkPolyData> DisplacedMesh;
  std::unique_ptr<TerrainProbe> Probe;
  std::string ExaggeratedBy; // what is reported of the exaggeration
};

#endif

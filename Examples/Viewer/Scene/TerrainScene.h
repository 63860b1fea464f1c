// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainScene
 * @brief   a height map with its imagery, or coloured by height
 */
#ifndef TerrainScene_h
#define TerrainScene_h

#include "Scene/SurfaceScene.h"

#include "vtkSmartPointer.h"

class SourceGround;
class vtkTerrainSource;

class TerrainScene : public SurfaceScene
{
public:
  /// Reads the files. Throws ViewerError.
  TerrainScene(const ViewerOptions& options, ViewerMessages& messages);
  ~TerrainScene() override;

  std::string GetUnit() override;
  std::string Describe(const double point[3], double resolution) override;
  void Report() override;
  void ResetView() override;

private:
  void AddDataCode(SceneCode& code) override;
  bool ApplyOptions(const OptionNames& changed) override;
  void AddExportedData(vtkPolyData* mesh) override;
  void ReadTerrain();
  void CheckReading();
  /// Heights and coordinates with different units, such as grey levels over texels, need a factor.
  void ChooseExaggeration();
  /// Whether coordinates are texels, because there is no georeference.
  bool CountsTexels();
  void CheckBudget();
  /// Adds the raster's heights, in its unit, at the mesh's texture coordinates.
  void AddHeights(vtkPolyData* mesh);
  void MakeDisplacedMesh();
  void KeepAboveGround();
  int GetDefaultLevel() override;
  vtkSmartPointer<vtkDepthTagMetric> MakeSceneMetric() override;
  void SetColours();

  vtkNew<vtkTerrainSource> Source;
  // The displaced coarse mesh, which the camera and the metrics use.
  vtkNew<vtkPolyData> DisplacedMesh;
  std::unique_ptr<SourceGround> Ground;
  std::string ExaggeratedBy; // reason for the exaggeration, for the report
};

#endif

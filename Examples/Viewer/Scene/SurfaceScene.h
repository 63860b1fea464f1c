// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceScene
 * @brief   a refined surface and its recipe
 *
 * The common part of height maps and meshes. Subclasses read the files and set colours.
 */
#ifndef SurfaceScene_h
#define SurfaceScene_h

#include "Scene/ViewerScene.h"

#include "vtkSmartPointer.h"

class vtkActor;
class vtkAdaptiveRefinement;
class vtkAdaptiveRefinementMapper;
class vtkDepthTagMetric;
class vtkImageData;
class vtkPolyData;

class SurfaceScene : public ViewerScene
{
public:
  ~SurfaceScene() override;

  void Export(const std::string& fileName) override;
  void Draw(vtkRenderWindow* window) override;
  SceneFigures GetFigures() override;
  std::vector<PatternCount> GetPatternCounts() override;

protected:
  SurfaceScene(const ViewerOptions& options, ViewerMessages& messages);

  OptionNames GetUpdatedOptions() override;
  bool ApplyOptions(const OptionNames& changed) override;
  virtual int GetDefaultLevel() = 0;
  /// Creates the metric of the options. Throws ViewerError.
  virtual vtkSmartPointer<vtkDepthTagMetric> MakeSceneMetric() = 0;

  /// Refines and draws this->Mesh.
  void Show(int maximumLevel, vtkDepthTagMetric* metric);
  /// Drapes an image over the mesh. Nothing is repeated beyond its borders.
  void SetTexture(vtkImageData* image);
  /// Sets colours by level, pattern or metric if the options request them.
  void SetLevelColours();
  /// Shows the whole surface, or the centre and zoom of the options.
  void SetCamera(vtkPolyData* surface, const ViewerDirection& defaultDirection,
    const std::optional<std::array<double, 3>>& centre);

  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  const vtkSmartPointer<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;

private:
  /// Adds arrays to a refined mesh before it is written.
  virtual void AddExportedData(vtkPolyData*) {}
  void SetRecipe(int maximumLevel, vtkDepthTagMetric* metric);
  void SetLevels(int maximumLevel, vtkDepthTagMetric* metric);
};

#endif

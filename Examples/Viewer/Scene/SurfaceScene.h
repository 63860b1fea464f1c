// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceScene
 * @brief   a surface that is refined, and its recipe
 *
 * What height maps and meshes have in common; subclasses read them and say how they look.
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

protected:
  SurfaceScene(const ViewerOptions& options, ViewerMessages& messages);

  /// Refines and draws this->Mesh.
  void Show(int maximumLevel, vtkDepthTagMetric* metric);
  /// Drapes an image, with nothing beyond its borders.
  void SetTexture(vtkImageData* image);
  /// Colours of levels, patterns or metric, where the options ask for them.
  void SetLevelColours();
  /// Shows all of a surface, or the centre and zoom that the options ask for.
  void SetCamera(vtkPolyData* surface, const ViewerDirection& defaultDirection,
    const std::optional<std::array<double, 3>>& centre);

  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  const vtkSmartPointer<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;

private:
  /// What else a refined mesh shall have in a file.
  virtual void AddExportedData(vtkPolyData*) {}
  void SetRecipe(int maximumLevel, vtkDepthTagMetric* metric);
};

#endif

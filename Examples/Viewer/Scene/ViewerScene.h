// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScene
 * @brief   a surface, its recipe, its light and the view of it
 *
 * What height maps and meshes have in common; subclasses read them and say how they look.
 */
#ifndef ViewerScene_h
#define ViewerScene_h

#include "Options/ViewerOptions.h"
#include "Scene/ViewerView.h"
#include "Text/ViewerMessages.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkAdaptiveRefinement;
class vtkAdaptiveRefinementMapper;
class vtkDepthTagMetric;
class vtkImageData;
class vtkPolyData;
class vtkRenderer;
class vtkRenderWindow;
class vtkScalarsToColors;

class ViewerScene
{
public:
  virtual ~ViewerScene();

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// The unit of lengths, "m" or "".
  virtual std::string GetUnit() = 0;

  /// Where a point of the surface is and what is there, in lines; lengths as exact as the
  /// resolution.
  virtual std::string Describe(const double point[3], double resolution) = 0;

  /// Writes the refined mesh as it is seen; throws ViewerError.
  void Export(const std::string& fileName);

  /// The first frame, with its costs on stdout where the options ask for them; throws ViewerError.
  void Draw(vtkRenderWindow* window);

protected:
  ViewerScene(const ViewerOptions& options, ViewerMessages& messages);

  /// Refines and draws this->Mesh.
  void Show(int maximumLevel, vtkDepthTagMetric* metric);
  /// Drapes an image, with nothing beyond its borders.
  void SetTexture(vtkImageData* image);
  /// Colours of levels, patterns or metric, where the options ask for them.
  void SetLevelColours();
  void AddLegend(vtkScalarsToColors* table, const std::string& title, int numberOfLabels);
  /// Shows all of a surface, or the centre and zoom that the options ask for; a direction that they
  /// do not give is the default.
  void SetCamera(vtkPolyData* surface, const ViewerDirection& defaultDirection,
    const std::optional<std::array<double, 3>>& centre);
  /// Light from the direction that the options give, else the first of the lamps; the others keep
  /// their azimuths from it.
  void SetLights(std::vector<ViewerLamp> lamps);

  const ViewerOptions& Options;
  ViewerMessages& Messages;
  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  const vtkSmartPointer<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;

private:
  /// What else a refined mesh shall have in a file.
  virtual void AddExportedData(vtkPolyData*) {}
  void SetRecipe(int maximumLevel, vtkDepthTagMetric* metric);

  bool HasLegend = false;
};

/// Reads the files; throws ViewerError.
std::unique_ptr<ViewerScene> MakeScene(const ViewerOptions& options, ViewerMessages& messages);

#endif

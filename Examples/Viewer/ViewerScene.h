// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScene
 * @brief   a terrain, its recipe, its light and the view of it
 */
#ifndef ViewerScene_h
#define ViewerScene_h

#include "ViewerMessages.h"
#include "ViewerOptions.h"

#include "vtkNew.h"

#include <iosfwd>

class vtkActor;
class vtkAdaptiveRefinement;
class vtkAdaptiveRefinementMapper;
class vtkPolyData;
class vtkRenderer;
class vtkRenderWindow;
class vtkTerrainSource;

class ViewerScene
{
public:
  /// Reads the files; throws ViewerError.
  ViewerScene(const ViewerOptions& options, ViewerMessages& messages);
  ~ViewerScene();

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// Writes the refined mesh as it is seen; throws ViewerError.
  void Export(const std::string& fileName);

  /// Draws frames until the time of one is known, and prints what they cost.
  void PrintStatistics(vtkRenderWindow* window, std::ostream& stream);

private:
  void ReadTerrain();
  int GetDefaultLevel();
  void SetLevels();
  void SetColours();
  void SetLevelColours();
  void SetLights();
  void SetCamera();

  const ViewerOptions& Options;
  ViewerMessages& Messages;
  vtkNew<vtkTerrainSource> Source;
  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkPolyData> DisplacedMesh;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
};

#endif

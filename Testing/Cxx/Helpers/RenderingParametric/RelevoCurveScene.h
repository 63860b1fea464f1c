// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Curves drawn by vtkAdaptiveCurveMapper, or the output of vtkAdaptiveCurveFilter drawn by
// vtkPolyDataMapper.
#ifndef RelevoCurveScene_h
#define RelevoCurveScene_h

#include "RelevoScene.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveCurveMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnstructuredGrid.h"

/// Random curves of one degree, Bézier or Lagrange, some of them joined. Point arrays are "Values",
/// "Radii", "Vectors" and "Colors", the cell array is "Numbers".
vtkSmartPointer<vtkUnstructuredGrid> RelevoMakeCurves(
  int degree, bool isLagrange = false, bool isRational = false);

class RelevoCurveScene
{
public:
  /// A black background without multisampling. The recipe has level 4 and no metric.
  explicit RelevoCurveScene(vtkDataObject* curves, int width = 200, int height = 160);

  /// Pictures of the mapper and of its twin, both with the mapper's current settings.
  RelevoPicture Draw();
  RelevoPicture DrawTwin();

  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveCurveMapper> Mapper;
  vtkNew<vtkAdaptiveCurveFilter> Filter;
  vtkNew<vtkPolyDataMapper> Twin;
};

#endif

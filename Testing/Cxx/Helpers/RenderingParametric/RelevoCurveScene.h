// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Curves in a window, drawn by vtkAdaptiveCurveMapper or, what vtkAdaptiveCurveFilter makes of
// them, by vtkPolyDataMapper.
#ifndef RelevoCurveScene_h
#define RelevoCurveScene_h

#include "RelevoScene.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveCurveMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnstructuredGrid.h"

/// Curves of a degree by chance, Bézier's or Lagrange's, some that go on where others end; with the
/// point arrays "Values", "Radii", "Vectors" and "Colors" and the cell array "Numbers".
vtkSmartPointer<vtkUnstructuredGrid> RelevoMakeCurves(
  int degree, bool isLagrange = false, bool isRational = false);

class RelevoCurveScene
{
public:
  /// Black behind, no multisamples; the recipe has level 4 and no metric.
  explicit RelevoCurveScene(vtkDataObject* curves, int width = 200, int height = 160);

  /// By the mapper, and by its twin, both with the mapper's settings as they are now.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws streaks around a sphere without a display. Prints how often they were convolved.
 */
#include "vtkActor.h"
#include "vtkAdaptiveLICMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkEGLOffscreenRenderWindow.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkPolyData* mesh = sphere->GetOutput();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Flow");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    vectors->InsertNextTuple3(-point[1], point[0], 0.0);
  }
  mesh->GetPointData()->SetVectors(vectors);

  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(surface);
  recipe->SetMaximumLevel(3);
  vtkNew<vtkAdaptiveLICMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetRefinement(recipe);

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkEGLOffscreenRenderWindow> window;
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  window->Render();
  window->Render(); // nothing has changed
  std::cout << mapper->GetNumberOfDrawnTriangles() << " triangles, "
            << mapper->GetNumberOfConvolutions() << " convolution\n";
  return mapper->GetNumberOfConvolutions() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}

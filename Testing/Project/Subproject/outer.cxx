// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A sphere, refined by a Relevo that the project has built.
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cstdlib>

int GetOwnNumber(); // of the project's other library

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  recipe->SetSurface(surface);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetRefinement(recipe);
  filter->Update();
  return filter->GetOutput()->GetNumberOfPolys() ==
      GetOwnNumber() * sphere->GetOutput()->GetNumberOfPolys()
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}

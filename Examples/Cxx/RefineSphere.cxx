// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A coarse sphere, refined to curved PN triangles. Prints how far the coarse and the refined mesh
 * are from the true sphere's area.
 */
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTriangle.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
// How much of the sphere's area a mesh misses, in percent.
double MissingArea(vtkPolyData* mesh, double radius)
{
  double area = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    area += vtkTriangle::SafeDownCast(mesh->GetCell(cell))->ComputeArea();
  }
  return 100.0 * (1.0 - area / (4.0 * vtkMath::Pi() * radius * radius));
}
}

int main()
{
  const double radius = 1.0;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(8);
  sphere->SetPhiResolution(8);
  sphere->Update();

  vtkNew<vtkAdaptiveRefinement> recipe;
  vtkNew<vtkPNTriangleSurface> surface;
  recipe->SetSurface(surface);
  recipe->SetMaximumLevel(3);

  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputConnection(sphere->GetOutputPort());
  refine->SetRefinement(recipe);
  refine->Update();

  vtkPolyData* coarse = sphere->GetOutput();
  vtkPolyData* fine = refine->GetOutput();
  const double before = MissingArea(coarse, radius);
  const double after = MissingArea(fine, radius);
  std::cout << "coarse:  " << coarse->GetNumberOfCells() << " triangles miss " << before
            << " % of the sphere's area\n"
            << "refined: " << fine->GetNumberOfCells() << " triangles miss " << after << " %\n";

  // Level 3 makes 4^3 triangles of one, and curved ones must come much closer to the sphere.
  const bool isRefined =
    fine->GetNumberOfCells() == 64 * coarse->GetNumberOfCells() && std::abs(after) < 0.2 * before;
  return isRefined ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Refines a coarse sphere with curved PN triangles. Prints how much the areas of the coarse and the
 * refined mesh differ from the sphere's.
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
// The area that a mesh lacks compared with the sphere, in percent.
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

  // At level 3, one triangle becomes 4^3. Curved triangles must be much closer to the sphere.
  const bool isRefined =
    fine->GetNumberOfCells() == 64 * coarse->GetNumberOfCells() && std::abs(after) < 0.2 * before;
  return isRefined ? EXIT_SUCCESS : EXIT_FAILURE;
}

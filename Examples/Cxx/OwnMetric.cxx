// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Example of a custom metric: high levels where z is large. Prints the number of triangles in both
 * halves of a sphere.
 */
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCell.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <iostream>

namespace
{
class AltitudeMetric : public vtkDepthTagMetric
{
public:
  static AltitudeMetric* New();
  vtkTypeMacro(AltitudeMetric, vtkDepthTagMetric);

  bool IsViewDependent() override { return false; }

  // The depth-tag rises from 0 at the bottom to maximumLevel at the top.
  bool ComputeTags(vtkPolyData* mesh, const relevo::RefinementView&, int maximumLevel,
    vtkFloatArray* tags) override
  {
    const double* bounds = mesh->GetBounds();
    const double extent = bounds[5] - bounds[4];
    tags->SetNumberOfComponents(1);
    tags->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double point[3];
      mesh->GetPoint(i, point);
      const double share = extent > 0.0 ? (point[2] - bounds[4]) / extent : 0.0;
      tags->SetValue(i, static_cast<float>(share * maximumLevel));
    }
    tags->Modified();
    return true;
  }
};
vtkStandardNewMacro(AltitudeMetric);
}

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<AltitudeMetric> metric;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMetric(metric);
  recipe->SetMaximumLevel(4);
  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputConnection(sphere->GetOutputPort());
  refine->SetRefinement(recipe);
  refine->Update();

  int triangles[2] = { 0, 0 };
  vtkPolyData* output = refine->GetOutput();
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const double* bounds = output->GetCell(cell)->GetBounds();
    ++triangles[bounds[4] + bounds[5] > 0.0 ? 1 : 0];
  }
  std::cout << triangles[0] << " triangles below, " << triangles[1] << " above\n";
  return triangles[1] > 10 * triangles[0] ? EXIT_SUCCESS : EXIT_FAILURE;
}

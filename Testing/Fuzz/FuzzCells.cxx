// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids, valid or not: patches, curves, ray casting and sorting.
#include "RelevoFuzzAssert.h"
#include "RelevoRandomGrid.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMeshVisibilitySort.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRayCastFilter.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe()
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(1);
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  return recipe;
}

void Sort(vtkUnstructuredGrid* grid, vtkCamera* camera)
{
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(grid);
  sort->SetCamera(camera);
  sort->InitTraversal();
  std::vector<bool> seen(static_cast<size_t>(grid->GetNumberOfCells()));
  while (vtkIdTypeArray* cells = sort->GetNextCells())
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
    {
      const vtkIdType cell = cells->GetValue(i);
      FUZZ_ASSERT(cell >= 0 && cell < grid->GetNumberOfCells());
      FUZZ_ASSERT(!seen[static_cast<size_t>(cell)]);
      seen[static_cast<size_t>(cell)] = true;
    }
  }
}

void Cast(vtkUnstructuredGrid* grid, vtkCamera* camera)
{
  vtkNew<vtkVolumeProperty> property;
  property->GetScalarOpacity()->AddPoint(0.0, 0.2);
  property->GetScalarOpacity()->AddPoint(1.0, 0.9);
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(1.0, 0.0, 1.0, 1.0);
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(grid);
  filter->SetCamera(camera);
  filter->SetVolumeProperty(property);
  filter->SetViewportSize(8, 8);
  filter->Update();
  auto* colors = vtkDoubleArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
  for (vtkIdType i = 0; colors && i < colors->GetNumberOfValues(); ++i)
  {
    FUZZ_ASSERT(std::isfinite(colors->GetValue(i)));
  }
}

void MakePatches(vtkUnstructuredGrid* grid, bool isSplit)
{
  vtkNew<vtkPatchSurfaceFilter> patches;
  patches->SetInputData(grid);
  patches->SetSplitPatches(isSplit);
  vtkNew<vtkAdaptiveRefinementFilter> refined;
  refined->SetInputConnection(patches->GetOutputPort());
  refined->SetRefinement(MakeRecipe());
  refined->Update();
  FUZZ_ASSERT(RelevoFuzz::IsFinite(refined->GetOutput()));
}

void MakeCurves(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkAdaptiveCurveFilter> filter;
  filter->SetInputData(grid);
  filter->SetRefinement(MakeRecipe());
  filter->SetRepresentationToTubes();
  filter->SetRadius(0.1);
  filter->Update();
  FUZZ_ASSERT(RelevoFuzz::IsFinite(filter->GetOutput()));
}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  vtkObject::GlobalWarningDisplayOff();
  RelevoFuzz::Dice dice(bytes, size);
  RelevoFuzz::RandomGrid grid(dice);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(2.5, 2.0, 3.0);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetClippingRange(0.1, 100.0);
  Sort(grid.Get(), camera);
  Cast(grid.Get(), camera);
  MakePatches(grid.Get(), dice.Once(2));
  MakeCurves(grid.Get());
  return 0;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that sorting and ray casting report an error with an empty output if memory runs out, and
// work again afterwards.
#include "RelevoCheck.h"
#include "RelevoMemory.h"
#include "RelevoVisibility.h"
#include "RelevoVolumes.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkMeshVisibilitySort.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

namespace
{
constexpr int Size = 24;
constexpr long Megabyte = 1 << 20;

void TestSort(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(Size, GetLinearField);
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  sort->SetCamera(MakeCamera({ { 3.0, 4.0, 5.0 } }, { { 0.5, 0.5, 0.5 } }));
  for (long megabytes : { 1, 4, 12 })
  {
    RelevoErrors errors(sort);
    {
      const RelevoMemoryLimit limit(megabytes * Megabyte);
      sort->InitTraversal();
    }
    CHECK_EQUAL(sort->GetNextCells(), nullptr);
    CHECK(errors.Said("Not enough memory for the order of the cells."));
  }
  CHECK_EQUAL(static_cast<vtkIdType>(Traverse(sort).size()), mesh->GetNumberOfCells());
}

void TestFilter(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(Size, GetLinearField);
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetVolumeProperty(MakeVolumeProperty(0.5, 1.0));
  filter->SetCamera(MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } }));
  filter->SetViewportSize(10, 10);
  for (long megabytes : { 1, 4, 8 })
  {
    RelevoErrors errors(filter);
    RelevoErrors executiveErrors(filter->GetExecutive());
    filter->Modified();
    {
      const RelevoMemoryLimit limit(megabytes * Megabyte);
      filter->Update();
    }
    CHECK(errors.Said("Not enough memory for the input or for 10 x 10 pixels."));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  filter->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 100);
}
}

int TestOutOfMemory(int, char*[])
{
  if (!RelevoMemoryLimit::Works())
  {
    return 125;
  }
  RelevoCheck check;
  vtkSMPTools::SetBackend("Sequential"); // threads need memory for their stacks
  TestSort(check);
  TestFilter(check);
  return check.GetResult();
}

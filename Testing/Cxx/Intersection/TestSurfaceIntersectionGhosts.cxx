// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises that ghost cells intersect nothing, with and without a
// recipe. The result is that of all cells without those of the ghost cells.
#include "RelevoCheck.h"
#include "RelevoIntersections.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkLinearSurface.h"
#include "vtkPoints.h"
#include "vtkStripper.h"
#include "vtkSurfaceIntersectionFilter.h"
#include "vtkUnsignedCharArray.h"

namespace
{
// Adds flags that are all 0.
vtkSmartPointer<vtkUnsignedCharArray> AddGhosts(vtkPolyData* mesh)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(mesh->GetNumberOfCells());
  ghosts->FillValue(0);
  mesh->GetCellData()->AddArray(ghosts);
  return ghosts;
}

// Midpoints of segments, without those of ghost cells or of all.
std::set<std::array<double, 3>> GetMiddles(vtkPolyData* curves, vtkUnsignedCharArray* ghosts)
{
  std::set<std::array<double, 3>> middles;
  vtkDataArray* cells = curves->GetCellData()->GetArray("Input1CellID");
  for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
  {
    if (ghosts && ghosts->GetValue(static_cast<vtkIdType>(cells->GetComponent(i, 0))) != 0)
    {
      continue;
    }
    double bounds[6];
    curves->GetCellBounds(i, bounds);
    middles.insert({ bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5] });
  }
  return middles;
}

void TestMesh(RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkPolyData> second;
  second->ShallowCopy(mesh);
  auto ghosts = AddGhosts(second);
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, RelevoMakeSphere(12, { 0.3, 0.2, 0.1 }, 1.0));
  filter->SetInputData(1, second);
  filter->SetRefinement(1, recipe);
  filter->ClassifyOn();
  filter->Update();
  vtkNew<vtkPolyData> curves;
  curves->ShallowCopy(filter->GetOutput());
  const auto all = GetMiddles(curves, nullptr);

  // Flags that are changed in place take effect, and no hidden cell contributes.
  const vtkIdType cut =
    static_cast<vtkIdType>(curves->GetCellData()->GetArray("Input1CellID")->GetComponent(0, 0));
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    ghosts->SetValue(i, i % 3 == cut % 3 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  ghosts->Modified();
  second->Modified();
  filter->Update();
  const auto own = GetMiddles(filter->GetOutput(), nullptr);
  CHECK(own == GetMiddles(curves, ghosts) && !own.empty() && own.size() < all.size());
  vtkCellData* data = filter->GetOutput(3)->GetCellData();
  CHECK_EQUAL(data->GetArray("Contact")->GetComponent(cut, 0), 0.0);
  CHECK_EQUAL(data->GetArray("Distance")->GetComponent(cut, 0), -1.0);

  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  ghosts->FillValue(vtkDataSetAttributes::DUPLICATECELL);
  ghosts->Modified();
  second->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK(recipe ? errors.Said("Input 1 has no refined triangle") : errors.None());

  second->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  second->Modified();
  filter->Update();
  CHECK_EQUAL(GetMiddles(filter->GetOutput(), nullptr), all);
}
}

int TestSurfaceIntersectionGhosts(int, char*[])
{
  RelevoCheck check;
  auto sphere = RelevoMakeSphere(16, { 0, 0, 0 }, 1.0);
  TestMesh(check, sphere, nullptr);
  vtkNew<vtkStripper> stripper;
  stripper->SetMaximumLength(3);
  stripper->SetInputData(sphere);
  stripper->Update();
  CHECK_GREATER(stripper->GetOutput()->GetNumberOfStrips(), 0);
  TestMesh(check, stripper->GetOutput(), nullptr);

  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(vtkNew<vtkLinearSurface>());
  recipe->SetMaximumLevel(2);
  TestMesh(check, sphere, recipe);
  return check.GetResult();
}

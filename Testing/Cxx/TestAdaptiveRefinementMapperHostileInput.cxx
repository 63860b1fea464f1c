// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells of points that do not exist, coloured, with edges and selected: an error, and nothing of it
// reaches VTK's maps of cells, which do not check.
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"

namespace
{
using namespace RelevoMeshes;

vtkSmartPointer<vtkCellArray> WithCell(vtkCellArray* cells, std::initializer_list<vtkIdType> cell)
{
  auto more = vtkSmartPointer<vtkCellArray>::New();
  more->DeepCopy(cells);
  more->InsertNextCell(cell);
  return more;
}
}

int TestAdaptiveRefinementMapperHostileInput(int, char*[])
{
  RelevoCheck check;
  constexpr vtkIdType lost = 1000000000;
  for (int kind = 0; kind < 4; ++kind)
  {
    Mesh mesh = Mixed();
    if (kind == 0)
    {
      mesh->SetVerts(WithCell(mesh->GetVerts(), { lost }));
    }
    else if (kind == 1)
    {
      mesh->SetLines(WithCell(mesh->GetLines(), { 0, lost }));
    }
    else if (kind == 2)
    {
      mesh->SetPolys(WithCell(mesh->GetPolys(), { 0, 1, lost, 3 }));
    }
    else
    {
      mesh->SetStrips(WithCell(mesh->GetStrips(), { lost, 1, 2, -5 }));
    }
    vtkNew<vtkFloatArray> scalars;
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      scalars->InsertNextValue(static_cast<float>(i));
    }
    mesh->GetCellData()->SetScalars(scalars);
    for (bool hasRecipe : { true, false })
    {
      RelevoScene scene(RelevoScene::Refining);
      scene.Window->SetSize(50, 50);
      scene.Add(mesh, MakeRecipe(1));
      if (!hasRecipe)
      {
        scene.GetMapper(0)->SetRefinement(nullptr);
      }
      RelevoErrors errors(scene.GetMapper(0));
      scene.GetActor(0)->GetProperty()->EdgeVisibilityOn();
      scene.ResetCameras();
      scene.Render();
      CHECK(errors.Said(hasRecipe ? "refers to point" : "No recipe"));
      RelevoPicks::SelectPixels(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
      RelevoPicks::SelectPixels(scene, vtkDataObject::FIELD_ASSOCIATION_POINTS);
      CHECK(RelevoPicture(scene.Window).CountForeground() == 0);
      // The next mesh is drawn.
      scene.GetMapper(0)->SetRefinement(MakeRecipe(1));
      scene.GetMapper(0)->SetInputDataObject(Mixed());
      scene.Render();
      CHECK(RelevoPicture(scene.Window).CountForeground() > 100);
    }
  }
  return check.GetResult();
}

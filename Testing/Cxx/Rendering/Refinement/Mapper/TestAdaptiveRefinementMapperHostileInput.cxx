// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that input which VTK's mapper and pickers do not check is an error and never reaches them:
// cells with invalid point ids, coloured, with edges or selected; arrays with too few tuples;
// colours of five components; lookup tables without a range; and cells with too few points.
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellPicker.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPointPicker.h"
#include "vtkProperty.h"

#include <limits>

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
vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(0.5);
  return array;
}

// Draws the mesh without colours after this error.
void ExpectColorless(RelevoCheck& check, vtkPolyData* mesh, const std::string& error,
  const std::function<void(vtkMapper*)>& set = {})
{
  RelevoScene scene(RelevoScene::Refining);
  scene.Window->SetSize(50, 50);
  scene.Add(mesh, MakeRecipe(1));
  set ? set(scene.GetMapper(0)) : void();
  scene.ResetCameras();
  {
    RelevoErrors errors(scene.GetMapper(0));
    scene.Render();
    CHECK(errors.Said(error));
    scene.Render();
    CHECK(errors.None()); // reported once
  }
  CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 100);
}

void TestColors(RelevoCheck& check)
{
  Mesh mesh = Sphere(8, 6);
  mesh->GetCellData()->SetScalars(MakeArray("Few", 1, 1));
  ExpectColorless(check, mesh, "Cannot colour by the array \"Few\": it has values for 1 of");
  mesh = Sphere(8, 6);
  mesh->GetPointData()->SetScalars(MakeArray("Few", 1, 3));
  ExpectColorless(check, mesh, "Cannot colour by the array \"Few\": it has values for 3 of");
  mesh = Sphere(8, 6);
  mesh->GetFieldData()->AddArray(MakeArray("Few", 1, 3));
  ExpectColorless(check, mesh, "no value 3",
    [](vtkMapper* mapper)
    {
      mapper->SetScalarModeToUseFieldData();
      mapper->SelectColorArray("Few");
      mapper->SetFieldDataTupleId(3);
    });
  mesh = Sphere(8, 6);
  mesh->GetPointData()->SetScalars(MakeArray("Five", 5, mesh->GetNumberOfPoints()));
  ExpectColorless(check, mesh, "\"Five\": it has 5 components",
    [](vtkMapper* mapper) { mapper->SetColorModeToDirectScalars(); });
  ExpectColorless(check, mesh, "is not finite",
    [](vtkMapper* mapper)
    { mapper->SetScalarRange(0.0, std::numeric_limits<double>::infinity()); });
}

// Colours by level, and arrays that VTK uses automatically.
void TestOthers(RelevoCheck& check)
{
  Mesh mesh = Sphere(8, 6);
  mesh->GetPointData()->SetNormals(nullptr);
  mesh->GetCellData()->SetNormals(MakeArray("Few", 3, 1));
  RelevoScene scene(RelevoScene::Refining);
  scene.Window->SetSize(50, 50);
  scene.Add(mesh, MakeRecipe(1));
  vtkNew<vtkLookupTable> table;
  table->SetTableRange(0.0, std::numeric_limits<double>::quiet_NaN());
  scene.GetMapper(0)->SetLevelLookupTable(table);
  scene.GetMapper(0)->SetColorModeToLevel();
  scene.ResetCameras();
  RelevoErrors errors(scene.GetMapper(0));
  scene.Render();
  CHECK(errors.Said("is not finite"));
  vtkNew<vtkLookupTable> notBuilt;
  notBuilt->SetTableRange(0.0, 1.0);
  scene.GetMapper(0)->SetLevelLookupTable(notBuilt);
  scene.Render();
  CHECK(errors.None());
  scene.GetMapper(0)->SetLevelLookupTable(nullptr);
  mesh->Modified();
  scene.Render();
  CHECK(errors.None()); // already reported for this array
  mesh->GetCellData()->GetAbstractArray("Few")->SetName("Fewer");
  mesh->Modified();
  scene.Render();
  CHECK(errors.Warned("Array \"Fewer\" has too few tuples"));
  CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 100);
}

// VTK's cell map is missing if a cell has too few points, or it refers to missing ones.
void TestPicks(RelevoCheck& check)
{
  for (bool isDrawn : { true, false })
  {
    CHECK_CASE(isDrawn);
    Mesh mesh = Sphere(8, 6);
    mesh->SetPolys(WithCell(mesh->GetPolys(), { 0, 1 }));
    mesh->SetLines(WithCell(mesh->GetLines(), { 0 }));
    if (!isDrawn)
    {
      mesh->SetStrips(WithCell(mesh->GetStrips(), { 0, 1, 1000000000 }));
    }
    RelevoScene scene(RelevoScene::Refining);
    scene.Window->SetSize(50, 50);
    scene.Add(mesh, MakeRecipe(1));
    scene.ResetCameras();
    RelevoErrors errors(scene.GetMapper(0));
    scene.Render();
    vtkNew<vtkCellPicker> cells;
    CHECK_EQUAL((cells->Pick(25.0, 25.0, 0.0, scene.Renderer) != 0), isDrawn);
    CHECK(!isDrawn || cells->GetCellId() > 0);
    vtkNew<vtkPointPicker> points;
    points->SetTolerance(0.2);
    CHECK_EQUAL((points->Pick(25.0, 25.0, 0.0, scene.Renderer) != 0), isDrawn);
  }
}

void TestLostPoints(RelevoCheck& check)
{
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
      CHECK(errors.Said(hasRecipe ? "refers to point" : "no recipe"));
      RelevoPicks::SelectPixels(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
      RelevoPicks::SelectPixels(scene, vtkDataObject::FIELD_ASSOCIATION_POINTS);
      CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
      // The next mesh is drawn.
      scene.GetMapper(0)->SetRefinement(MakeRecipe(1));
      scene.GetMapper(0)->SetInputDataObject(Mixed());
      scene.Render();
      CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 100);
    }
  }
}
}

int TestAdaptiveRefinementMapperHostileInput(int, char*[])
{
  RelevoCheck check;
  TestLostPoints(check);
  TestColors(check);
  TestOthers(check);
  TestPicks(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a picker that misses the bounds does not change the mapper's input. Other callers get
// the coarse input at its points, and the next pick finds the refined surface.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCellPicker.h"
#include "vtkDisplacement.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointPicker.h"

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

// A plane at height 0, drawn at height 3 and seen from above.
struct Table
{
  explicit Table(vtkDataObject* data)
  {
    vtkNew<vtkDisplacement> displacement;
    displacement->SetOffset(3.0);
    displacement->SetDirection(0.0, 0.0, 1.0);
    this->Scene.MoveCamera = [](vtkCamera*) {};
    this->Scene.Add(data, MakeRecipe(1, nullptr, displacement));
    this->Scene.ResetCameras();
    this->Scene.Renderer->GetActiveCamera()->Zoom(0.5);
    this->Scene.Render();
  }
  bool Pick(vtkPicker* picker, double share)
  {
    const int* size = this->Scene.Window->GetSize();
    return picker->Pick(share * size[0], share * size[1], 0.0, this->Scene.Renderer) != 0;
  }
  Mapper* GetMapper() { return this->Scene.GetMapper(0); }
  RelevoScene Scene{ RelevoScene::Refining };
};

using Miss = std::function<void(Table&)>;

std::vector<Miss> GetMisses()
{
  return { [](Table& table) { table.Pick(vtkNew<vtkCellPicker>(), 0.02); },
    [](Table& table) { table.Pick(vtkNew<vtkPointPicker>(), 0.02); },
    [](Table& table)
    {
      double bounds[6];
      table.GetMapper()->GetBounds(bounds); // the only request, by a user
    } };
}

void TestMesh(RelevoCheck& check)
{
  Mesh mesh = Plane(3, 3);
  for (const Miss& miss : GetMisses())
  {
    Table table(mesh);
    miss(table);
    CHECK_EQUAL(table.GetMapper()->GetInputAsDataSet(), mesh);
    miss(table);
    vtkDataObject* input = table.GetMapper()->GetInputDataObject(0, 0);
    CHECK(input == mesh && vtkPolyData::SafeDownCast(input));
    miss(table);
    CHECK_EQUAL(table.GetMapper()->GetInput(), mesh);
    CHECK_EQUAL(mesh->GetPoint(0)[2], 0.0);
    miss(table);
    vtkNew<vtkCellPicker> picker;
    CHECK(table.Pick(picker, 0.5));
    CHECK_NEAR(picker->GetPickPosition()[2], 3.0, 1e-6);
    vtkNew<vtkPointPicker> points;
    points->SetTolerance(0.5);
    CHECK(table.Pick(points, 0.5));
    CHECK_NEAR(points->GetPickPosition()[2], 3.0, 1e-6);
  }
}

// Requests before a pass, for example for the opacity of blocks, do not change what is drawn.
void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Plane(3, 3));
  for (const Miss& miss : GetMisses())
  {
    Table table(blocks);
    Mapper* mapper = table.GetMapper();
    const vtkIdType uploads = mapper->GetNumberOfBufferBuilds();
    miss(table);
    CHECK_EQUAL(mapper->GetInputDataObject(0, 0), blocks);
    miss(table);
    CHECK(mapper->HasOpaqueGeometry() && !mapper->HasTranslucentPolygonalGeometry());
    table.Scene.Render();
    CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), uploads);
    miss(table);
    vtkNew<vtkCellPicker> picker;
    CHECK(table.Pick(picker, 0.5));
    CHECK_NEAR(picker->GetPickPosition()[2], 3.0, 1e-6);
    CHECK_EQUAL(picker->GetFlatBlockIndex(), 1);
  }
}
}

int TestAdaptiveRefinementMapperMissedPicks(int, char*[])
{
  RelevoCheck check;
  TestMesh(check);
  TestBlocks(check);
  return check.GetResult();
}

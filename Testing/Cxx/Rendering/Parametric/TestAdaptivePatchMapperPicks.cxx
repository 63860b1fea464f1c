// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptivePatchMapper promises picks with the grid's cells and parametric coordinates, for
// grids, patches and blocks. Cells that cannot be evaluated are reported once.
#include "RelevoPatchScene.h"
#include "RelevoPatches.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellPicker.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
// For a grid of 2 x 2 squares, a cell's r and s are x and y relative to its corner.
void TestPicks(RelevoCheck& check, vtkDataObject* input)
{
  RelevoPatchScene scene(input, 2.0);
  scene.Draw();
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0);
  for (int y = 31; y < 270; y += 14)
  {
    for (int x = 31; x < 270; x += 14)
    {
      // VTK's pickers use the lower left corner of a pixel.
      picker->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer);
      double pcoords[3] = { -1.0, -1.0, -1.0 };
      const vtkIdType cell = scene.Mapper->GetPickedCell(picker, pcoords);
      const double* place = picker->GetMapperPosition();
      const vtkIdType expected =
        static_cast<vtkIdType>(std::floor(place[0]) + 2.0 * std::floor(place[1]));
      CHECK_EQUAL(cell, expected);
      CHECK_NEAR(pcoords[0], place[0] - std::floor(place[0]), 1e-5);
      CHECK_NEAR(pcoords[1], place[1] - std::floor(place[1]), 1e-5);
      CHECK_EQUAL(pcoords[2], 0.0);
      double found[3];
      CHECK_EQUAL(scene.Mapper->GetPickedCell(picker->GetCellId(), place, found,
                    vtkPolyData::SafeDownCast(picker->GetDataSet())),
        expected);
      CHECK_NEAR(found[0], pcoords[0], 1e-5);
      CHECK_NEAR(found[1], pcoords[1], 1e-5);
    }
  }
  picker->Pick(2.0, 2.0, 0.0, scene.Renderer);
  double nothing[3] = { 7.0, 7.0, 7.0 };
  CHECK_EQUAL(scene.Mapper->GetPickedCell(picker, nothing), -1);
  CHECK_EQUAL(scene.Mapper->GetPickedCell(nullptr, nothing), -1);
  CHECK_EQUAL(scene.Mapper->GetPickedCell(1000, nothing, nothing), -1);
  CHECK_EQUAL(nothing[0], 7.0);
}

// Parametric coordinates on curved patches, found from positions only.
void TestCurved(RelevoCheck& check, int type, bool isRational)
{
  auto grid = RelevoNewCell(type, { { 3, 3, 0 } }, 0.05, isRational);
  auto patches = RelevoMakePatches(grid);
  vtkNew<vtkAdaptivePatchMapper> mapper;
  mapper->SetInputDataObject(grid);
  const bool isTriangle = RelevoIsTriangle(patches, 0);
  for (double u = 0.0; u <= 1.0; u += 0.125)
  {
    for (double v = 0.0; v <= (isTriangle ? 1.0 - u : 1.0); v += 0.125)
    {
      const std::vector<double> place = RelevoEvaluatePatch(patches, 0, u, v);
      double pcoords[3];
      CHECK_EQUAL(mapper->GetPickedCell(0, place.data(), pcoords), 0);
      CHECK_NEAR(pcoords[0], u, 2e-5);
      CHECK_NEAR(pcoords[1], v, 2e-5);
    }
  }
}

void TestErrors(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_LAGRANGE_QUADRILATERAL, { { 4, 4, 0 } }, 0.0);
  auto patches = RelevoMakePatches(grid);
  RelevoPatchScene without(patches);
  without.Mapper->ExactScalarsOff();
  const RelevoPicture interpolated = without.Draw();

  vtkNew<vtkPolyData> missing;
  missing->ShallowCopy(patches);
  missing->GetFieldData()->RemoveArray("PatchNodes:Field");
  {
    RelevoPatchScene scene(missing);
    RelevoErrors errors(scene.Mapper);
    scene.Mapper->SetIsolineSpacing(0.1);
    CHECK_EQUAL(scene.Draw().Colors, interpolated.Colors);
    CHECK(errors.None());
  }
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("PatchNodes:Field");
  tooShort->SetNumberOfTuples(3);
  tooShort->Fill(0.0);
  missing->GetFieldData()->AddArray(tooShort);
  {
    RelevoPatchScene scene(missing);
    RelevoErrors errors(scene.Mapper);
    CHECK_EQUAL(scene.Draw().Colors, interpolated.Colors);
    CHECK(errors.Said("the array PatchNodes:Field has 3 tuples of 1 components, but 25 "
                      "tuples of 1 are needed"));
    scene.Draw();
    CHECK(errors.None()); // reported once
    missing->GetFieldData()->AddArray(patches->GetFieldData()->GetArray("PatchNodes:Field"));
    missing->Modified();
    CHECK_NOT_EQUAL(scene.Draw().Colors, interpolated.Colors);
    CHECK(errors.None());
  }
  // The mapper reports the filter's errors.
  auto wrong = RelevoNewFlatGrid(1, 1);
  wrong->GetPoints()->SetPoint(0, std::nan(""), 0.0, 0.0);
  RelevoPatchScene scene(RelevoNewFlatGrid(1, 1));
  RelevoErrors errors(scene.Mapper);
  scene.Draw();
  CHECK(errors.None());
  scene.Mapper->SetInputData(wrong);
  scene.Draw();
  CHECK(errors.Said("Not all of the grid can be drawn"));
}
}

int TestAdaptivePatchMapperPicks(int, char*[])
{
  RelevoCheck check;
  auto grid = RelevoNewFlatGrid(2, 2);
  TestPicks(check, grid);
  auto patches = RelevoMakePatches(grid);
  TestPicks(check, patches);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, patches);
  TestPicks(check, blocks);
  for (bool isRational : { false, true })
  {
    CHECK_CASE(isRational);
    TestCurved(check, VTK_BEZIER_QUADRILATERAL, isRational);
    TestCurved(check, VTK_BEZIER_TRIANGLE, isRational);
  }
  TestErrors(check);
  return check.GetResult();
}

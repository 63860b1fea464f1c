// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on picking: pickers find the levels that were drawn, also if a triangle budget or
// the graphics card chose them, and no ghost cells.
#include "RelevoPickers.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkPNTriangleSurface.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

// The twin's filter uses the level offset of the budget.
void Compare(RelevoCheck& check, const std::string& name, const std::function<void(Mapper*)>& setUp,
  bool withOffset)
{
  const auto makeRecipe = []()
  {
    vtkNew<vtkPNTriangleSurface> surface;
    vtkNew<vtkDistanceDepthTagMetric> metric;
    metric->SetMaximumDistance(4.0);
    auto recipe = MakeRecipe(5, surface);
    recipe->SetMetric(metric);
    return recipe;
  };
  RelevoScene refining(RelevoScene::Refining);
  RelevoScene twin(RelevoScene::Twin);
  const auto expected = makeRecipe();
  refining.Add(Sphere(9, 7), makeRecipe());
  twin.Add(Sphere(9, 7), expected);
  setUp(refining.GetMapper(0));
  refining.ResetCameras();
  twin.UpdateFilters();
  twin.CopyCameras(refining);
  refining.Render();
  if (withOffset)
  {
    expected->SetLevelOffset(refining.GetMapper(0)->GetLevelOffset());
    CHECK_GREATER(std::abs(expected->GetLevelOffset()), 0.01);
  }
  else
  {
    CHECK_EQUAL(refining.GetMapper(0)->GetSelectionDeviceInUse(), Mapper::SELECTION_DEVICE_GPU);
  }
  twin.Render();
  CHECK_GREATER(RelevoPickers::Compare(refining, twin, 60, name), 5);
}

void CheckGhosts(RelevoCheck& check)
{
  Mesh mesh = Plane(6, 6);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    ghosts->InsertNextValue(id % 3 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  mesh->GetCellData()->AddArray(ghosts);
  RelevoScene scene(RelevoScene::Refining);
  RelevoPickers::DrawFromFront(scene, mesh, MakeRecipe(2));
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0);
  double center[3];
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    double pcoords[3];
    double weights[8];
    int subId = mesh->GetCell(id)->GetParametricCenter(pcoords);
    mesh->GetCell(id)->EvaluateLocation(subId, pcoords, center, weights);
    const auto display = RelevoPickers::ToDisplay(scene.Renderer, center[0], center[1], center[2]);
    const bool isHit = picker->Pick(display[0], display[1], 0.0, scene.Renderer) != 0;
    CHECK_EQUAL(isHit, (id % 3 != 0));
    CHECK(!isHit || picker->GetCellId() == id);
  }
}
}

int TestAdaptiveRefinementMapperPicksLevels(int, char*[])
{
  RelevoCheck check;
  Compare(
    check, "budget", [](Mapper* mapper) { mapper->SetTargetNumberOfTriangles(3000); }, true);
  Compare(
    check, "GPU", [](Mapper* mapper) { mapper->SetSelectionDeviceToGPU(); }, false);
  CheckGhosts(check);
  return check.GetResult();
}

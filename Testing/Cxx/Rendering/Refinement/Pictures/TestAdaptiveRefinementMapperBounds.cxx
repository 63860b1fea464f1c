// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the bounds of the mapper contain everything it draws and are not much larger, and
// that ResetCamera shows all of it.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <cmath>

namespace
{
using namespace RelevoMeshes;

// The filter's output lies within the mapper's bounds.
void CheckContained(RelevoCheck& check, const std::string& name, vtkPolyData* mesh,
  vtkAdaptiveRefinement* recipe, vtkAdaptiveRefinementMapper* mapper)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(mesh);
  filter->SetRefinement(recipe);
  filter->Update();
  double drawn[6];
  filter->GetOutput()->GetCellsBounds(drawn);
  double bounds[6];
  mapper->GetBounds(bounds);
  const double length = filter->GetOutput()->GetLength();
  for (int i = 0; i < 6; ++i)
  {
    const double outside = (i % 2 ? 1.0 : -1.0) * (drawn[i] - bounds[i]);
    if (!(outside <= 1e-6 * length))
    {
      check.Fail(__FILE__, __LINE__,
        name + ": bound " + std::to_string(i) + " is exceeded by " + std::to_string(outside));
    }
  }
}

// ResetCamera leaves a margin of background on all sides.
void CheckSeenWhole(RelevoCheck& check, const std::string& name, RelevoScene& scene)
{
  for (int view = 0; view < 6; ++view)
  {
    scene.Renderer->ResetCamera();
    scene.Renderer->GetActiveCamera()->Azimuth(63);
    scene.Renderer->GetActiveCamera()->Elevation(view % 2 ? 25 : -20);
    scene.Renderer->ResetCameraClippingRange();
    scene.Render();
    const RelevoPicture picture(scene.Window);
    bool cut = false;
    bool clipped = false;
    for (int y = 0; y < picture.Size[1]; ++y)
    {
      for (int x = 0; x < picture.Size[0]; ++x)
      {
        const size_t i = static_cast<size_t>(y) * picture.Size[0] + x;
        const bool rim = x == 0 || y == 0 || x + 1 == picture.Size[0] || y + 1 == picture.Size[1];
        const bool background = picture.Colors[3 * i] < 100;
        cut = cut || (rim && !background);
        clipped = clipped || (!background && picture.Depths[i] <= 0.0f);
      }
    }
    if (cut || clipped || picture.CountForeground() < 2000)
    {
      check.Fail(__FILE__, __LINE__,
        name + (cut ? ": cut by the window's rim" : ": clipped") + " in view " +
          std::to_string(view));
    }
  }
}

void CheckBounds(
  RelevoCheck& check, const std::string& name, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, recipe)->GetProperty()->LightingOff();
  CheckContained(check, name, mesh, recipe, scene.GetMapper(0));
  CheckSeenWhole(check, name, scene);
}

void TestContained(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(32, 32, 1);
  CheckBounds(check, "sphere", Sphere(9, 7), MakeRecipe(4, surface, nullptr));
  CheckBounds(check, "coarse sphere", Sphere(4, 3), MakeRecipe(4, surface, nullptr));
  CheckBounds(check, "rough sphere", TexturedSphere(9, 7),
    MakeRecipe(5, surface, MakeDisplacement(rough, 1)));
  CheckBounds(check, "sunken sphere", TexturedSphere(9, 7),
    MakeRecipe(5, surface, MakeDisplacement(rough, -0.2, -0.1)));
  CheckBounds(
    check, "rough cube", Cube(), MakeRecipe(5, surface, MakeDisplacement(rough, 0.5, 0.1)));
  CheckBounds(
    check, "rough linear cube", Cube(), MakeRecipe(5, nullptr, MakeDisplacement(rough, 0.5, 0.1)));
  CheckBounds(
    check, "mountain", Plane(3, 3), MakeRecipe(6, nullptr, MakeDisplacement(rough, 3, 5)));
  auto slanted = MakeDisplacementAlong(1, 2, 3, rough, 2);
  CheckBounds(check, "slanted mountain", Plane(3, 3), MakeRecipe(6, nullptr, slanted));
  const double far[3] = { 5e6, -4e6, 3e6 };
  CheckBounds(check, "far sphere", Moved(TexturedSphere(9, 7), 100, far, VTK_DOUBLE),
    MakeRecipe(4, surface, MakeDisplacement(rough, 30, 0)));
  CheckBounds(check, "mixed cells", Mixed(), MakeRecipe(3, surface, nullptr));
}

// The bounds are tight: a flat plane grows only along its normal, by exactly the largest
// displacement.
void TestTight(RelevoCheck& check)
{
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(32, 32, 1);
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetInputDataObject(Plane(4, 5));
  auto displacement = MakeDisplacement(rough, 10, -2);
  mapper->SetRefinement(MakeRecipe(4, nullptr, displacement));
  double range[2];
  rough->GetRange(range);
  double bounds[6];
  mapper->GetBounds(bounds);
  CHECK_NEAR(bounds[0], -0.5, 1e-6);
  CHECK_NEAR(bounds[1], 0.5, 1e-6);
  CHECK_NEAR(bounds[2], -0.5, 1e-6);
  CHECK_NEAR(bounds[3], 0.5, 1e-6);
  CHECK_NEAR(bounds[4], 10 * range[0] - 2, 1e-5);
  CHECK_NEAR(bounds[5], 10 * range[1] - 2, 1e-5);

  // Bounds follow changes at once.
  displacement->SetScale(0);
  displacement->SetOffset(7);
  mapper->GetBounds(bounds);
  CHECK_NEAR(bounds[4], 7, 1e-6);
  CHECK_NEAR(bounds[5], 7, 1e-6);
  displacement->SetDirection(1, 0, 0);
  mapper->GetBounds(bounds);
  CHECK_NEAR(bounds[0], 6.5, 1e-6);
  CHECK_NEAR(bounds[1], 7.5, 1e-6);
  CHECK_NEAR(bounds[5], 0, 1e-6);
  mapper->GetRefinement()->SetDisplacement(nullptr);
  mapper->GetBounds(bounds);
  CHECK_NEAR(bounds[1], 0.5, 1e-6);
  mapper->SetInputDataObject(Sphere(60, 40));
  mapper->GetBounds(bounds);
  CHECK_NEAR(bounds[5], 0.5, 1e-6);
}

// For an offset sphere they are within one percent.
void TestOffset(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  Mesh sphere = TexturedSphere(60, 30);
  mapper->SetInputDataObject(sphere);
  mapper->SetRefinement(MakeRecipe(2, surface, MakeDisplacement(nullptr, 1, 0.5)));
  double bounds[6];
  mapper->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    CHECK(std::abs(bounds[i]) >= 0.9999 && std::abs(bounds[i]) <= 1.01);
  }
}

// Vertices and lines beside the faces, and all blocks, are included.
void TestOtherCells(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  Mesh lone = Mixed();
  lone->GetPoints()->SetPoint(23, 50, 0, 0); // a vertex
  mapper->SetInputDataObject(lone);
  mapper->SetRefinement(MakeRecipe(2, surface, nullptr));
  double bounds[6];
  mapper->GetBounds(bounds);
  CHECK_NEAR(bounds[1], 50, 1e-5);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, TexturedSphere(9, 7));
  const double up[3] = { 0, 0, 5 };
  blocks->SetBlock(2, Moved(TexturedSphere(20, 15), 1, up, VTK_FLOAT));
  mapper->SetInputDataObject(blocks);
  mapper->GetBounds(bounds);
  CHECK(bounds[4] <= -0.5 && bounds[4] > -0.52);
  CHECK(bounds[5] >= 5.5 && bounds[5] < 5.52);
  mapper->GetRefinement()->SetDisplacement(MakeDisplacement(nullptr, 1, 1));
  mapper->GetBounds(bounds);
  CHECK(bounds[5] >= 6.5 && bounds[5] < 6.55);
  blocks->SetBlock(2, nullptr);
  mapper->GetBounds(bounds);
  CHECK(bounds[5] >= 1.5 && bounds[5] < 1.7);
}

// Without input or cells there are no bounds, and nothing crashes.
void TestNothing(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetRefinement(MakeRecipe(2, nullptr, nullptr));
  CHECK(!vtkMath::AreBoundsInitialized(mapper->GetBounds()));
  vtkNew<vtkPolyData> nothing;
  mapper->SetInputDataObject(nothing);
  CHECK(!vtkMath::AreBoundsInitialized(mapper->GetBounds()));
  vtkNew<vtkMultiBlockDataSet> none;
  mapper->SetInputDataObject(none);
  CHECK(!vtkMath::AreBoundsInitialized(mapper->GetBounds()));
}
}

int TestAdaptiveRefinementMapperBounds(int, char*[])
{
  RelevoCheck check;
  TestContained(check);
  TestTight(check);
  TestOffset(check);
  TestOtherCells(check);
  TestNothing(check);
  return check.GetResult();
}

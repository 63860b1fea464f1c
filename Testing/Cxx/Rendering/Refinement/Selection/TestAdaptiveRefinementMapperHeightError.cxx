// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// With vtkHeightErrorDepthTagMetric, the mapper promises the triangles of the filter, for all
// methods that draw patterns, on both selection devices, for placed actors and for blocks, and it
// follows changes of the recipe and the view.
#include "RelevoCheck.h"
#include "RelevoHeights.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkDisplacement.h"
#include "vtkHeightErrorDepthTagMetric.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkPolyData> MakeStrip(double from, double to)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(from, 0.0, 0.0);
  plane->SetPoint1(to, 0.0, 0.0);
  plane->SetPoint2(from, 1.0, 0.0);
  plane->SetResolution(3, 6);
  plane->Update();
  vtkSmartPointer<vtkPolyData> mesh = plane->GetOutput();
  return mesh;
}

struct Scene
{
  Scene()
  {
    this->Heights->Fill(65, 65,
      [](double x, double y)
      { return 0.2 * std::exp(-20.0 * ((x - 0.4) * (x - 0.4) + (y - 0.6) * (y - 0.6))); });
    this->Displacement->SetHeightMap(this->Heights);
    this->Metric->SetScreenSpaceError(0.5);
    this->Recipe->SetMetric(this->Metric);
    this->Recipe->SetMaximumLevel(5);
    this->Recipe->SetDisplacement(this->Displacement);
    this->Mapper->SetRefinement(this->Recipe);
    this->Filter->SetRefinement(this->Recipe);
    this->Filter->SetCamera(this->Renderer->GetActiveCamera());
    this->Filter->SetViewportSize(200, 150);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->GetActiveCamera()->SetPosition(0.5, -1.5, 2.0);
    this->Renderer->GetActiveCamera()->SetFocalPoint(0.5, 0.5, 0.0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(200, 150);
    this->Window->AddRenderer(this->Renderer);
  }

  vtkIdType CountDrawn()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    return this->Mapper->GetNumberOfDrawnTriangles() + this->Mapper->GetNumberOfCulledTriangles();
  }

  vtkIdType CountRefined(vtkPolyData* mesh)
  {
    this->Filter->SetInputData(mesh);
    this->Filter->Update();
    return this->Filter->GetOutput()->GetNumberOfPolys();
  }

  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkHeightErrorDepthTagMetric> Metric;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void TestMethods(RelevoCheck& check)
{
  Scene scene;
  const auto mesh = MakeStrip(0.0, 1.0);
  scene.Mapper->SetInputData(mesh);
  for (int rule = 0; rule < 2; ++rule)
  {
    scene.Recipe->SetLevelRule(rule);
    const vtkIdType refined = scene.CountRefined(mesh);
    CHECK_GREATER(refined, 4 * 36);
    for (int method :
      { vtkAdaptiveRefinementMapper::METHOD_ARKFPI, vtkAdaptiveRefinementMapper::METHOD_ARK })
    {
      for (int device : { 0, 1 })
      {
        CHECK_CASE(method);
        CHECK_CASE(device);
        scene.Mapper->SetMethod(method);
        scene.Mapper->SetSelectionDevice(device);
        CHECK_EQUAL(scene.CountDrawn(), refined);
      }
    }
  }
}

// A smaller placement takes fewer triangles in units of the world, and so does a farther camera.
void TestChanges(RelevoCheck& check)
{
  Scene scene;
  const auto mesh = MakeStrip(0.0, 1.0);
  scene.Mapper->SetInputData(mesh);
  const vtkIdType near = scene.CountDrawn();
  scene.Renderer->GetActiveCamera()->SetPosition(0.5, -15.0, 20.0);
  CHECK_LESS(scene.CountDrawn(), near);
  scene.Metric->SetMaximumError(0.01);
  const vtkIdType whole = scene.CountDrawn();
  CHECK_EQUAL(whole, scene.CountRefined(mesh));
  scene.Actor->SetScale(4.0);
  CHECK_GREATER(scene.CountDrawn(), whole);
  scene.Metric->SetMaximumError(0.04);
  CHECK_EQUAL(scene.CountDrawn(), whole);
  scene.Displacement->SetScale(4.0);
  CHECK_GREATER(scene.CountDrawn(), whole);
  scene.Displacement->SetScale(1.0);
  CHECK_EQUAL(scene.CountDrawn(), whole);
  // Other patterns are measured again.
  scene.Recipe->SetSegmentPolicyToWholeNumbers();
  scene.Metric->SetMaximumError(0.01);
  scene.Actor->SetScale(1.0);
  CHECK_EQUAL(scene.CountDrawn(), scene.CountRefined(mesh));
  CHECK_NOT_EQUAL(scene.CountDrawn(), whole);
}

// Edges at the borders of blocks have the highest level.
void TestBlocks(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMaximumError(0.005);
  const auto left = MakeStrip(0.0, 0.5);
  const auto right = MakeStrip(0.5, 1.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, left);
  blocks->SetBlock(1, right);
  scene.Mapper->SetInputDataObject(blocks);
  const vtkIdType drawn = scene.CountDrawn();
  const vtkIdType separate = scene.CountRefined(left) + scene.CountRefined(right);
  scene.Metric->MaximumLevelOnBorderOn();
  CHECK_EQUAL(drawn, scene.CountRefined(left) + scene.CountRefined(right));
  CHECK_GREATER(drawn, separate);
  CHECK_EQUAL(scene.CountDrawn(), drawn);
}
}

int TestAdaptiveRefinementMapperHeightError(int, char*[])
{
  RelevoCheck check;
  TestMethods(check);
  TestChanges(check);
  TestBlocks(check);
  return check.GetResult();
}

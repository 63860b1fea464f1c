// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that for 64 blocks and a moving camera, a metric prepares each block only once on both
// devices, and that the filter gives the same number of triangles.
#include "RelevoMeshArrays.h"
#include "RelevoScene.h"
#include "RelevoWatched.h"

#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

namespace
{
using Mapper = vtkAdaptiveRefinementMapper;

constexpr int NumberOfFrames = 3;
constexpr int NumberOfBlocks = 64;

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(vtkDepthTagMetric* metric, int rule)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(2);
  recipe->SetMetric(metric);
  recipe->SetLevelRule(rule);
  return recipe;
}

vtkIdType CountFilterTriangles(
  vtkMultiBlockDataSet* blocks, vtkAdaptiveRefinement* recipe, RelevoScene& scene)
{
  vtkIdType triangles = 0;
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(recipe);
  filter->SetCamera(scene.Renderer->GetActiveCamera());
  filter->SetViewportSize(scene.Renderer->GetSize()[0], scene.Renderer->GetSize()[1]);
  for (unsigned int block = 0; block < blocks->GetNumberOfBlocks(); ++block)
  {
    filter->SetInputDataObject(blocks->GetBlock(block));
    filter->Update();
    triangles += filter->GetOutput()->GetNumberOfPolys();
  }
  return triangles;
}

// Draws frames with a metric that is new to the mapper. Later frames must not read the meshes.
void DrawFrames(
  RelevoCheck& check, RelevoScene& scene, vtkMultiBlockDataSet* blocks, vtkDepthTagMetric* metric)
{
  scene.Render();
  RelevoWatchedFloats::GetReads() = 0;
  for (int frame = 1; frame < NumberOfFrames; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(7.0);
    scene.Renderer->ResetCameraClippingRange();
    scene.Render();
  }
  if (!CHECK_EQUAL(RelevoWatchedFloats::GetReads(), 0))
  {
    std::cerr << metric->GetClassName() << ": " << RelevoWatchedFloats::GetReads()
              << " points are read again\n";
  }
  Mapper* mapper = scene.GetMapper(0);
  CHECK_GREATER(mapper->GetNumberOfDrawnTriangles(), 4 * NumberOfBlocks);
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(),
    CountFilterTriangles(blocks, mapper->GetRefinement(), scene));
}

// Relevo's metrics that prepare data of a mesh, and a composite of all.
void TestOwnMetrics(RelevoCheck& check, vtkMultiBlockDataSet* blocks, int device)
{
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  vtkNew<vtkViewDependentDepthTagMetric> viewDependent;
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
  vtkNew<vtkSilhouetteDepthTagMetric> contour;
  contour->SetCriterionToContour();
  vtkNew<vtkScreenEdgeDepthTagMetric> screenEdge;
  vtkNew<vtkDistanceDepthTagMetric> distance;
  vtkNew<vtkDistanceDepthTagMetric> pixels;
  pixels->SetReferenceLength(4.0);
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetRadius(3.0);
  vtkNew<vtkCompositeDepthTagMetric> all;
  all->SetModeToSum();
  std::vector<vtkDepthTagMetric*> metrics{ curvature, viewDependent, silhouette, contour,
    screenEdge, distance, pixels, region };
  for (vtkDepthTagMetric* metric : metrics)
  {
    all->AddMetric(metric, 0.2);
  }
  metrics.push_back(all);

  RelevoScene scene(RelevoScene::Refining);
  const auto recipe = MakeRecipe(nullptr, vtkDepthTagMetric::PER_VERTEX);
  scene.Add(blocks, recipe);
  scene.GetMapper(0)->SetSelectionDevice(device);
  scene.ResetCameras();
  scene.Render();
  scene.Render();
  // Without a metric no more values are read. Curvature reads them.
  RelevoWatchedFloats::GetReads() = 0;
  scene.Render();
  CHECK_EQUAL(RelevoWatchedFloats::GetReads(), 0);
  recipe->SetMetric(curvature);
  scene.Render();
  CHECK_GREATER(RelevoWatchedFloats::GetReads(), 10 * NumberOfBlocks);
  for (vtkDepthTagMetric* metric : metrics)
  {
    recipe->SetMetric(metric);
    DrawFrames(check, scene, blocks, metric);
  }
  recipe->SetLevelRule(vtkDepthTagMetric::PER_EDGE);
  DrawFrames(check, scene, blocks, all);
}

// A custom metric gets one evaluator per block, each with one mesh.
void TestOneEvaluatorPerBlock(
  RelevoCheck& check, vtkMultiBlockDataSet* blocks, int device, int rule)
{
  vtkNew<RelevoWatchedMetric> metric;
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(blocks, MakeRecipe(metric, rule));
  scene.GetMapper(0)->SetSelectionDevice(device);
  scene.ResetCameras();
  for (int frame = 1; frame <= NumberOfFrames; ++frame)
  {
    scene.Render();
    CHECK_EQUAL(metric->Evaluators, NumberOfBlocks);
    CHECK_EQUAL(metric->Preparations, NumberOfBlocks);
    CHECK_EQUAL(metric->Evaluations, frame * NumberOfBlocks);
    scene.Renderer->GetActiveCamera()->Azimuth(7.0);
  }
  // Only a block that has changed is prepared again, even if only its colours have changed.
  auto* moved = vtkPolyData::SafeDownCast(blocks->GetBlock(5));
  moved->GetPoints()->SetPoint(0, 0.1, 0.2, 0.3);
  moved->GetPoints()->Modified();
  blocks->Modified();
  scene.Render();
  CHECK_EQUAL(metric->Evaluators, NumberOfBlocks);
  CHECK_EQUAL(metric->Preparations, NumberOfBlocks + 1);
  RelevoMeshes::AddTags(moved, 1, 3);
  moved->GetPointData()->GetArray("DepthTag")->SetName("Colors");
  blocks->Modified();
  scene.Render();
  CHECK_EQUAL(metric->Preparations, NumberOfBlocks + 1);
}
}

int TestAdaptiveRefinementMapperMetrics(int, char*[])
{
  RelevoCheck check;
  for (int device : { Mapper::SELECTION_DEVICE_CPU, Mapper::SELECTION_DEVICE_GPU })
  {
    CHECK_CASE(device);
    TestOwnMetrics(check, MakeWatchedBlocks(), device);
    for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
    {
      CHECK_CASE(rule);
      TestOneEvaluatorPerBlock(check, MakeWatchedBlocks(), device, rule);
    }
  }
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthTagMetric promises that it can be shared: each filter has one evaluator per mesh. Tests
// metrics without evaluators, composites whose parts change, and one recipe in two filters in two
// threads.
#include "RelevoAllMetrics.h"
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"
#include "RelevoWatched.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDepthTagFilter.h"
#include "vtkImageData.h"
#include "vtkImplicitDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace
{
vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(vtkDepthTagMetric* metric)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(3);
  recipe->SetMetric(metric);
  return recipe;
}

// When the camera moves, the metric prepares each mesh only once.
template <typename Filter, typename Setter>
void TestFilter(RelevoCheck& check, RelevoWatchedMetric* metric, const Setter& set)
{
  constexpr int side = 3;
  auto blocks = MakeWatchedBlocks(side);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(1.0, 1.0, 9.0);
  vtkNew<Filter> filter;
  vtkNew<vtkCompositeDataPipeline> pipeline;
  filter->SetExecutive(pipeline);
  filter->SetInputDataObject(blocks);
  filter->SetCamera(camera);
  set(filter.Get());
  for (int frame = 1; frame <= 5; ++frame)
  {
    camera->Azimuth(9.0);
    filter->Update();
    CHECK_EQUAL(metric->Evaluators, side * side);
    CHECK_EQUAL(metric->Preparations, side * side);
    CHECK_EQUAL(metric->Evaluations, frame * side * side);
  }
  // The evaluator of a removed block is deleted, and a new block gets a new one.
  blocks->SetBlock(2, RelevoMeshes::Cube());
  filter->Update();
  CHECK_EQUAL(metric->Evaluators, side * side + 1);
  CHECK_EQUAL(metric->Preparations, side * side + 1);
}

void TestFilters(RelevoCheck& check)
{
  vtkNew<RelevoWatchedMetric> metric;
  TestFilter<vtkAdaptiveRefinementFilter>(check, metric,
    [&](vtkAdaptiveRefinementFilter* filter) { filter->SetRefinement(MakeRecipe(metric)); });
  vtkNew<RelevoWatchedMetric> other;
  TestFilter<vtkDepthTagFilter>(
    check, other, [&](vtkDepthTagFilter* filter) { filter->SetMetric(other); });
}

// Evaluators of meshes that a filter no longer refines are deleted, even if the meshes still exist.
template <typename Filter, typename Setter>
void TestMemory(RelevoCheck& check, RelevoWatchedMetric* metric, const Setter& set)
{
  vtkNew<vtkCamera> camera;
  vtkNew<Filter> filter;
  vtkNew<vtkCompositeDataPipeline> pipeline;
  filter->SetExecutive(pipeline);
  filter->SetCamera(camera);
  set(filter.Get());
  std::vector<RelevoMeshes::Mesh> meshes;
  for (int i = 0; i < 20; ++i)
  {
    meshes.push_back(RelevoMeshes::Cube());
    filter->SetInputData(meshes.back());
    filter->Update();
    CHECK_EQUAL(metric->Evaluators, i + 1);
    CHECK_LESS_EQUAL(metric->LivingEvaluators, 2);
  }
  // Other blocks replace the first ones, which stay alive elsewhere.
  auto blocks = MakeWatchedBlocks(2);
  const auto others = MakeWatchedBlocks(2);
  filter->SetInputDataObject(blocks);
  vtkNew<vtkMultiBlockDataSet> kept;
  kept->ShallowCopy(blocks);
  filter->Update();
  for (unsigned int i = 0; i < 4; ++i)
  {
    blocks->SetBlock(i, others->GetBlock(i));
  }
  for (int frame = 0; frame < 3; ++frame)
  {
    camera->Azimuth(9.0);
    filter->Update();
    CHECK_EQUAL(metric->Evaluators, 28);
  }
  CHECK_EQUAL(metric->LivingEvaluators, 4);
}

void TestMemory(RelevoCheck& check)
{
  vtkNew<RelevoWatchedMetric> metric;
  const auto recipe = MakeRecipe(metric);
  TestMemory<vtkAdaptiveRefinementFilter>(
    check, metric, [&](vtkAdaptiveRefinementFilter* filter) { filter->SetRefinement(recipe); });
  CHECK_EQUAL(metric->LivingEvaluators, 0);

  // Without a metric nothing is cached.
  vtkNew<vtkCamera> camera;
  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputData(RelevoMeshes::Cube());
  refine->SetRefinement(recipe);
  refine->SetCamera(camera);
  refine->Update();
  CHECK_EQUAL(metric->LivingEvaluators, 1);
  recipe->SetMetric(nullptr);
  refine->Update();
  CHECK_EQUAL(metric->LivingEvaluators, 0);

  vtkNew<RelevoWatchedMetric> other;
  TestMemory<vtkDepthTagFilter>(
    check, other, [&](vtkDepthTagFilter* filter) { filter->SetMetric(other); });
  vtkNew<vtkDepthTagFilter> tag;
  tag->SetInputData(RelevoMeshes::Cube());
  tag->SetCamera(camera);
  tag->SetMetric(other);
  tag->Update();
  CHECK_EQUAL(other->LivingEvaluators, 1);
  tag->SetMetric(nullptr);
  CHECK_EQUAL(other->LivingEvaluators, 0);
}

// How often points are read in the first run and after the camera has moved.
std::pair<long, long> CountReads(vtkDepthTagMetric* metric)
{
  auto blocks = MakeWatchedBlocks(1);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetMaximumLevel(0);
  filter->SetInputDataObject(blocks->GetBlock(0));
  filter->SetCamera(camera);
  filter->SetMetric(metric);
  RelevoWatchedFloats::GetReads() = 0;
  filter->Update();
  const long first = RelevoWatchedFloats::GetReads().exchange(0);
  camera->Azimuth(9.0);
  filter->Modified();
  filter->Update();
  return { first, RelevoWatchedFloats::GetReads() };
}

// Curvature is not recomputed when the filter executes again.
void TestCurvature(RelevoCheck& check)
{
  vtkNew<RelevoWatchedMetric> plain;
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  const auto without = CountReads(plain);
  const auto with = CountReads(curvature);
  CHECK_GREATER(with.first, without.first + 50);
  CHECK_EQUAL(with.second, without.second);
}

// Returns too few tags or none.
class NoTags : public vtkDepthTagMetric
{
public:
  static NoTags* New() { VTK_STANDARD_NEW_BODY(NoTags); }
  vtkTypeMacro(NoTags, vtkDepthTagMetric);
  bool IsViewDependent() override { return false; }
};

class FewTags : public NoTags
{
public:
  static FewTags* New() { VTK_STANDARD_NEW_BODY(FewTags); }
  vtkTypeMacro(FewTags, NoTags);
  bool ComputeTags(vtkPolyData*, const relevo::RefinementView&, int, vtkFloatArray* tags) override
  {
    tags->SetNumberOfTuples(2);
    tags->FillComponent(0, 1.0);
    return true;
  }
};

void TestErrors(RelevoCheck& check)
{
  auto mesh = RelevoMeshes::Cube();
  const relevo::RefinementView view;
  vtkNew<NoTags> none;
  RelevoErrors errors(none);
  CHECK(KeptMetric(none).GetTags(mesh, view, 3).empty());
  CHECK(errors.Said("override ComputeTags() or NewEvaluator()"));
  CHECK(KeptMetric(none).GetEdgeTags(mesh, view, 3).empty());
  CHECK(errors.Said("override ComputeTags() or NewEvaluator()"));
  vtkNew<FewTags> few;
  RelevoErrors fewErrors(few);
  CHECK(KeptMetric(few).GetEdgeTags(mesh, view, 3).empty());
  CHECK(fewErrors.Said("returned 2 tags for"));
}

// The evaluator of a composite follows changes of weights and parts, and parts of the same metric.
void TestComposite(RelevoCheck& check)
{
  auto mesh = RelevoMeshes::Sphere(9, 7);
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
  view.Camera = camera;
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  vtkNew<vtkViewDependentDepthTagMetric> viewDependent;
  vtkNew<RelevoWatchedMetric> watched;
  vtkNew<vtkCompositeDepthTagMetric> composite;
  composite->SetModeToSum();
  KeptMetric kept(composite);
  const auto compare = [&]
  {
    for (int step = 0; step < 3; ++step)
    {
      camera->Azimuth(10.0);
      CHECK_EQUAL(kept.GetTags(mesh, view, 4), TagsOf(composite, mesh, view, 4));
      const relevo::SurfaceEdges edges(mesh);
      CHECK_EQUAL(kept.GetEdgeTags(mesh, view, 4), EdgeTagsOf(composite, mesh, view, 4, edges));
    }
  };
  composite->AddMetric(curvature, 0.5);
  compare();
  composite->AddMetric(viewDependent, 0.5);
  composite->AddMetric(watched, 0.1);
  composite->AddMetric(viewDependent, 0.1);
  compare();
  composite->RemoveAllMetrics();
  composite->AddMetric(watched);
  composite->AddMetric(curvature, 0.1);
  compare();
}

// A filter with a mesh, a camera and its result.
class Runner
{
public:
  Runner(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
  {
    this->Camera->SetPosition(2.0, 1.0, 3.0);
    this->Filter->SetInputData(mesh);
    this->Filter->SetRefinement(recipe);
    this->Filter->SetCamera(this->Camera);
  }

  void Run(int repetitions)
  {
    for (int i = 0; i < repetitions; ++i)
    {
      this->Camera->SetPosition(2.0 + 0.1 * (i % 7), 1.0, 3.0 - 0.1 * (i % 5));
      this->Filter->Update();
      vtkPolyData* output = this->Filter->GetOutput();
      const vtkIdType points = output->GetNumberOfPoints();
      double sum = 0.0;
      for (vtkIdType point = 0; point < points; ++point)
      {
        double x[3];
        output->GetPoint(point, x);
        sum += x[0] + 2.0 * x[1] + 3.0 * x[2];
      }
      this->Results.emplace_back(output->GetNumberOfPolys(), sum);
    }
  }

  std::vector<std::pair<vtkIdType, double>> Results;

private:
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
};

void TestThreads(RelevoCheck& check, vtkDepthTagMetric* metric, int rule, int repetitions)
{
  const auto run = [&](bool inThreads)
  {
    auto recipe = MakeRecipe(metric);
    recipe->SetLevelRule(rule);
    Runner first(RelevoMeshes::Sphere(11, 9), recipe);
    Runner second(RelevoMeshes::Torus(10, 7), recipe);
    if (inThreads)
    {
      std::thread thread([&] { first.Run(repetitions); });
      second.Run(repetitions);
      thread.join();
    }
    else
    {
      first.Run(repetitions);
      second.Run(repetitions);
    }
    return std::make_pair(first.Results, second.Results);
  };
  const auto together = run(true);
  const auto apart = run(false);
  CHECK_EQUAL(together, apart);
  CHECK_EQUAL(static_cast<int>(apart.first.size()), repetitions);
  CHECK(!metric->IsViewDependent() || apart.first[0] != apart.first[1]);
  CHECK(apart.first[0].first > 1000 && apart.second[0].first > 1000);
}

// A ball that, like many implicit functions of VTK, only one thread may evaluate at a time. It
// detects concurrent calls.
class WatchedFunction : public vtkImplicitFunction
{
public:
  static WatchedFunction* New() { VTK_STANDARD_NEW_BODY(WatchedFunction); }
  vtkTypeMacro(WatchedFunction, vtkImplicitFunction);

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override
  {
    this->Overlaps += ++this->Askers > 1;
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    --this->Askers;
    return vtkMath::Norm(x) - 0.45;
  }
  void EvaluateGradient(double x[3], double gradient[3]) override
  {
    std::copy_n(x, 3, gradient);
    vtkMath::Normalize(gradient);
  }

  std::atomic<int> Overlaps{ 0 };

private:
  std::atomic<int> Askers{ 0 };
};

void TestFunctionInThreads(RelevoCheck& check)
{
  vtkNew<vtkRegionDepthTagMetric> region;
  vtkNew<WatchedFunction> watched;
  region->SetImplicitFunction(watched);
  region->SetFallOff(3.0);
  for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
  {
    CHECK_CASE(rule);
    TestThreads(check, region, rule, 5);
  }
  CHECK_EQUAL(watched->Overlaps, 0);

  // This function modifies a member during evaluation.
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 9);
  image->SetOrigin(-2, -2, -2);
  image->SetSpacing(0.5, 0.5, 0.5);
  vtkNew<vtkFloatArray> distances;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    distances->InsertNextValue(static_cast<float>(vtkMath::Norm(image->GetPoint(i)) - 0.3));
  }
  image->GetPointData()->SetScalars(distances);
  vtkNew<vtkImplicitDataSet> values;
  values->SetDataSet(image);
  region->SetImplicitFunction(values);
  TestThreads(check, region, vtkDepthTagMetric::PER_VERTEX, 50);
}
}

int TestMetricEvaluators(int, char*[])
{
  RelevoCheck check;
  TestFilters(check);
  TestMemory(check);
  TestCurvature(check);
  TestErrors(check);
  TestComposite(check);
  for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
  {
    CHECK_CASE(rule);
    TestThreads(check, RelevoMakeSum(RelevoMakeAllMetrics("Normals"), 0.15), rule, 150);
  }
  TestFunctionInThreads(check);
  return check.GetResult();
}

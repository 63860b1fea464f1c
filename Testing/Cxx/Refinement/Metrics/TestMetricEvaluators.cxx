// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Evaluators of metrics: one for each mesh, owned by the filter; metrics without; composites whose
// parts change; one recipe in two filters in two threads.
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
#include "vtkViewDependentDepthTagMetric.h"

#include <thread>
#include <utility>

namespace
{
vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(vtkDepthTagMetric* metric)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(3);
  recipe->SetMetric(metric);
  return recipe;
}

// A filter whose camera moves: the metric meets each of its meshes once.
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
    CHECK(metric->Evaluators == side * side && metric->Preparations == side * side);
    CHECK(metric->Evaluations == frame * side * side);
  }
  // A block that is gone takes what is known of it along; what is in its place is new.
  blocks->SetBlock(2, RelevoMeshes::Cube());
  filter->Update();
  CHECK(metric->Evaluators == side * side + 1 && metric->Preparations == side * side + 1);
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

// How often points are read when a filter runs for the first time and after its camera moved.
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

// Curvature is not computed again when the filter runs again.
void TestCurvature(RelevoCheck& check)
{
  vtkNew<RelevoWatchedMetric> plain;
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  const auto without = CountReads(plain);
  const auto with = CountReads(curvature);
  CHECK(with.first > without.first + 50);
  CHECK(with.second == without.second);
}

// Too short, or nothing at all.
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
  CHECK(fewErrors.Said("gave 2 tags for"));
}

// A composite's evaluator follows it: weights, parts that come and go, parts of one metric.
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
      CHECK(kept.GetTags(mesh, view, 4) == TagsOf(composite, mesh, view, 4));
      relevo::SurfaceEdges edges;
      edges.Update(mesh);
      CHECK(kept.GetEdgeTags(mesh, view, 4) == EdgeTagsOf(composite, mesh, view, 4, edges));
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

//------------------------------------------------------------------------------
// Threads

// A filter with a mesh and a camera of its own, and what it gave.
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

void TestThreads(RelevoCheck& check, int rule)
{
  constexpr int repetitions = 150;
  const auto run = [&](bool inThreads)
  {
    auto recipe = MakeRecipe(RelevoMakeSum(RelevoMakeAllMetrics("Normals"), 0.15));
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
  CHECK(together == apart);
  CHECK(apart.first.size() == repetitions && apart.first[0] != apart.first[1]);
  CHECK(apart.first[0].first > 1000 && apart.second[0].first > 1000);
}
}

int TestMetricEvaluators(int, char*[])
{
  RelevoCheck check;
  TestFilters(check);
  TestCurvature(check);
  TestErrors(check);
  TestComposite(check);
  TestThreads(check, vtkDepthTagMetric::PER_VERTEX);
  TestThreads(check, vtkDepthTagMetric::PER_EDGE);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCompositeDepthTagMetric: combinations by hand, its parts' times, cycles.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkCompositeDepthTagMetric.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkRegionDepthTagMetric.h"

#include <cmath>

namespace
{
// The levels it is given, and a count of how often it was asked.
class GivenLevels : public vtkDepthTagMetric
{
public:
  static GivenLevels* New();
  vtkTypeMacro(GivenLevels, vtkDepthTagMetric);
  bool IsViewDependent() override { return this->ViewDependent; }
  bool ComputeTags(vtkPolyData*, const relevo::RefinementView&, int, vtkFloatArray* tags) override
  {
    ++this->Count;
    tags->SetNumberOfTuples(static_cast<vtkIdType>(this->Levels.size()));
    std::copy(this->Levels.begin(), this->Levels.end(), tags->GetPointer(0));
    return true;
  }
  std::vector<float> Levels;
  bool ViewDependent = false;
  int Count = 0;
};
vtkStandardNewMacro(GivenLevels);
}

int TestCompositeDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkCompositeDepthTagMetric> metric;
  RelevoErrors errors(metric);
  relevo::RefinementView view;
  auto mesh = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
  CHECK(TagsOf(metric, mesh, view, 4).empty() && errors.Said("no metrics"));
  CHECK(!metric->IsViewDependent() && metric->GetNumberOfMetrics() == 0);

  vtkNew<GivenLevels> first;
  vtkNew<GivenLevels> second;
  first->Levels = { 0, 1, 4 };
  second->Levels = { 3, 2, 4 };
  metric->AddMetric(first);
  metric->AddMetric(second, 0.5);
  CHECK(metric->GetNumberOfMetrics() == 2 && metric->GetMetric(1) == second.Get());
  CHECK(metric->GetWeight(0) == 1.0 && metric->GetWeight(1) == 0.5);
  CHECK(!metric->GetMetric(2) && !metric->GetMetric(-1) && metric->GetWeight(2) == 0.0);
  CHECK(TagsOf(metric, mesh, view, 4) == std::vector<float>({ 1.5f, 1.0f, 4.0f }));
  metric->SetModeToSum();
  CHECK(TagsOf(metric, mesh, view, 4) == std::vector<float>({ 1.5f, 2.0f, 4.0f }));
  metric->SetModeToProduct();
  auto tags = TagsOf(metric, mesh, view, 4);
  CHECK_NEAR(tags[0], 0.0, 1e-6);
  CHECK_NEAR(tags[1], 4.0 * 0.25 * std::sqrt(0.5), 1e-5);
  CHECK_NEAR(tags[2], 4.0, 1e-6);
  CHECK(TagsOf(metric, mesh, view, 0) == std::vector<float>(3, 0.0f));
  metric->AddMetric(second, 0.0);
  CHECK(TagsOf(metric, mesh, view, 4) == tags);

  // What does not depend on the view is kept until something changes; the rest is not.
  KeptMetric kept(metric);
  CHECK(kept.GetTags(mesh, view, 4) == tags);
  const int firstCount = first->Count;
  second->ViewDependent = true;
  CHECK(metric->IsViewDependent());
  const int secondCount = second->Count;
  kept.GetTags(mesh, view, 4);
  CHECK(first->Count == firstCount && second->Count > secondCount);
  kept.GetTags(mesh, view, 5);
  CHECK(first->Count == firstCount + 1);
  mesh->GetPoints()->Modified();
  kept.GetTags(mesh, view, 5);
  CHECK(first->Count == firstCount + 2);
  const vtkMTimeType time = metric->GetMTime();
  first->Modified();
  CHECK(metric->GetMTime() > time);
  kept.GetTags(mesh, view, 5);
  CHECK(first->Count == firstCount + 3);

  // Real ones, and nested: never less than any part by the maximum, never more by the product.
  std::mt19937 random(6);
  vtkNew<vtkCamera> camera;
  view.Camera = camera;
  auto sphere = RelevoMeshes::Sphere(12, 9);
  vtkNew<vtkDistanceDepthTagMetric> distance;
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetRadius(0.4);
  region->SetCenter(0.5, 0, 0);
  region->SetFallOff(0.5);
  vtkNew<vtkCompositeDepthTagMetric> all;
  vtkNew<vtkCompositeDepthTagMetric> nested;
  nested->AddMetric(region);
  CHECK(!nested->IsViewDependent());
  all->AddMetric(distance);
  all->AddMetric(nested);
  CHECK(all->IsViewDependent());
  for (int i = 0; i < 60; ++i)
  {
    PlaceAtRandom(camera, random);
    const auto near = TagsOf(distance, sphere, view, 5);
    const auto inside = TagsOf(region, sphere, view, 5);
    all->SetMode(i % 3);
    const auto both = TagsOf(all, sphere, view, 5);
    CHECK(AreLevels(both, sphere->GetNumberOfPoints(), 5));
    for (std::size_t point = 0; point < both.size(); ++point)
    {
      const float most = std::max(near[point], inside[point]);
      const float least = std::min(near[point], inside[point]);
      CHECK(i % 3 != 0 || both[point] == most);
      CHECK(i % 3 != 1 || std::abs(both[point] - std::min(most + least, 5.0f)) < 1e-5f);
      CHECK(i % 3 != 2 || both[point] <= least + 1e-5f);
    }
  }
  CHECK(SurvivesOddMeshes(all));

  // Errors.
  const int before = metric->GetNumberOfMetrics();
  metric->AddMetric(nullptr);
  CHECK(errors.Said("no metric"));
  metric->AddMetric(metric);
  CHECK(errors.Said("contain itself"));
  vtkNew<vtkCompositeDepthTagMetric> outer;
  vtkNew<vtkCompositeDepthTagMetric> middle;
  middle->AddMetric(metric);
  outer->AddMetric(middle);
  metric->AddMetric(outer);
  CHECK(errors.Said("contain itself"));
  for (double bad : { -1.0, 1e9, std::nan("") })
  {
    metric->AddMetric(first, bad);
    CHECK(errors.Said("Weight"));
  }
  CHECK(metric->GetNumberOfMetrics() == before);
  metric->SetMode(3);
  CHECK(errors.Said("Mode") && metric->GetMode() == vtkCompositeDepthTagMetric::PRODUCT);
  metric->RemoveAllMetrics();
  CHECK(metric->GetNumberOfMetrics() == 0);
  metric->AddMetric(distance);
  view.Camera = nullptr;
  RelevoErrors ofPart(distance);
  CHECK(TagsOf(metric, mesh, view, 4).empty());
  CHECK(ofPart.Said("no camera") && errors.Said("vtkDistanceDepthTagMetric"));
  return check.GetResult();
}

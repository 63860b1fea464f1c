// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCompositeDepthTagMetric promises the maximum, sum or product of its metrics, checked against
// values computed by hand. Cycles are errors, and changes of a part take effect.
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
// Returns given levels and counts its calls.
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

// Two metrics with given levels for a triangle, and a composite of both.
struct Pair
{
  Pair()
  {
    this->First->Levels = { 0, 1, 4 };
    this->Second->Levels = { 3, 2, 4 };
  }
  std::vector<float> GetTags(int maximumLevel)
  {
    return TagsOf(this->Metric, this->Mesh, this->View, maximumLevel);
  }

  vtkNew<vtkCompositeDepthTagMetric> Metric;
  vtkNew<GivenLevels> First;
  vtkNew<GivenLevels> Second;
  relevo::RefinementView View;
  RelevoMeshes::Mesh Mesh = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
};

void TestModes(RelevoCheck& check, Pair& pair)
{
  vtkCompositeDepthTagMetric* metric = pair.Metric;
  RelevoErrors errors(metric);
  CHECK(pair.GetTags(4).empty() && errors.Said("no metrics"));
  CHECK(!metric->IsViewDependent() && metric->GetNumberOfMetrics() == 0);

  metric->AddMetric(pair.First);
  metric->AddMetric(pair.Second, 0.5);
  CHECK_EQUAL(metric->GetNumberOfMetrics(), 2);
  CHECK_EQUAL(metric->GetMetric(1), pair.Second.Get());
  CHECK_EQUAL(metric->GetWeight(0), 1.0);
  CHECK_EQUAL(metric->GetWeight(1), 0.5);
  CHECK(!metric->GetMetric(2) && !metric->GetMetric(-1) && metric->GetWeight(2) == 0.0);
  CHECK_EQUAL(pair.GetTags(4), std::vector<float>({ 1.5f, 1.0f, 4.0f }));
  metric->SetModeToSum();
  CHECK_EQUAL(pair.GetTags(4), std::vector<float>({ 1.5f, 2.0f, 4.0f }));
  metric->SetModeToProduct();
  const auto tags = pair.GetTags(4);
  CHECK_NEAR(tags[0], 0.0, 1e-6);
  CHECK_NEAR(tags[1], 4.0 * 0.25 * std::sqrt(0.5), 1e-5);
  CHECK_NEAR(tags[2], 4.0, 1e-6);
  CHECK_EQUAL(pair.GetTags(0), std::vector<float>(3, 0.0f));
  metric->AddMetric(pair.Second, 0.0);
  CHECK_EQUAL(pair.GetTags(4), tags);
}

// Tags of metrics that do not depend on the view are cached until something changes. Other tags are
// not.
void TestKept(RelevoCheck& check, Pair& pair)
{
  vtkCompositeDepthTagMetric* metric = pair.Metric;
  KeptMetric kept(metric);
  CHECK_EQUAL(kept.GetTags(pair.Mesh, pair.View, 4), pair.GetTags(4));
  const int firstCount = pair.First->Count;
  pair.Second->ViewDependent = true;
  CHECK(metric->IsViewDependent());
  const int secondCount = pair.Second->Count;
  kept.GetTags(pair.Mesh, pair.View, 4);
  CHECK_EQUAL(pair.First->Count, firstCount);
  CHECK_GREATER(pair.Second->Count, secondCount);
  kept.GetTags(pair.Mesh, pair.View, 5);
  CHECK_EQUAL(pair.First->Count, firstCount + 1);
  pair.Mesh->GetPoints()->Modified();
  kept.GetTags(pair.Mesh, pair.View, 5);
  CHECK_EQUAL(pair.First->Count, firstCount + 2);
  const vtkMTimeType time = metric->GetMTime();
  pair.First->Modified();
  CHECK_GREATER(metric->GetMTime(), time);
  kept.GetTags(pair.Mesh, pair.View, 5);
  CHECK_EQUAL(pair.First->Count, firstCount + 3);
}

// With real and nested metrics, the maximum is never below any part, and the product never above.
void TestNested(RelevoCheck& check)
{
  std::mt19937 random(6);
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
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
}

// A composite without metrics, cycles, weights and modes. Errors leave the metric unchanged.
void TestErrors(RelevoCheck& check, Pair& pair)
{
  vtkCompositeDepthTagMetric* metric = pair.Metric;
  RelevoErrors errors(metric);
  const int before = metric->GetNumberOfMetrics();
  metric->AddMetric(nullptr);
  CHECK(errors.Said("Cannot add the metric"));
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
    CHECK_CASE(bad);
    metric->AddMetric(pair.First, bad);
    CHECK(errors.Said("Weight"));
  }
  CHECK_EQUAL(metric->GetNumberOfMetrics(), before);
  metric->SetMode(3);
  CHECK(errors.Said("Mode") && metric->GetMode() == vtkCompositeDepthTagMetric::PRODUCT);
}

// A part that fails reports the cause, and the composite reports which part failed.
void TestFailingPart(RelevoCheck& check, Pair& pair)
{
  vtkCompositeDepthTagMetric* metric = pair.Metric;
  RelevoErrors errors(metric);
  vtkNew<vtkDistanceDepthTagMetric> distance; // fails without a camera
  metric->RemoveAllMetrics();
  CHECK_EQUAL(metric->GetNumberOfMetrics(), 0);
  metric->AddMetric(distance);
  RelevoErrors partErrors(distance);
  CHECK(pair.GetTags(4).empty());
  CHECK(partErrors.Said("no camera") && errors.Said("vtkDistanceDepthTagMetric"));
}
}

int TestCompositeDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  Pair pair;
  TestModes(check, pair);
  TestKept(check, pair);
  TestNested(check);
  TestErrors(check, pair);
  TestFailingPart(check, pair);
  return check.GetResult();
}

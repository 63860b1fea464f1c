// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkViewDependentAlgorithm promises: vtkAdaptiveRefinementFilter, vtkRefinedCellLocator and
// vtkDepthTagFilter have the same view settings, depend on camera and matrix only if the metric
// does, and apply the actor's matrix.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDepthTagFilter.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkRefinedCellLocator.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using namespace RelevoMeshes;

// The three classes with the same view.
struct Subjects
{
  Subjects()
  {
    this->Recipe->SetMaximumLevel(2);
    this->Camera->SetPosition(0.0, 0.0, 3.0);
    this->Filter->SetInputData(this->Input);
    this->Filter->SetRefinement(this->Recipe);
    this->Locator->SetDataSet(this->Input);
    this->Locator->SetRefinement(this->Recipe);
    this->Tagger->SetInputData(this->Input);
    this->SetView(this->Filter.Get());
    this->SetView(this->Locator.Get());
    this->SetView(this->Tagger.Get());
  }
  template <typename Subject>
  void SetView(Subject* subject)
  {
    const int size[2] = { 400, 300 };
    subject->SetCamera(this->Camera);
    subject->SetModelToWorld(this->Place);
    subject->SetViewportSize(size);
  }
  void SetMetric(vtkDepthTagMetric* metric)
  {
    this->Recipe->SetMetric(metric);
    this->Tagger->SetMetric(metric);
    this->Count([] {});
  }
  // How many of the three execute again after a change.
  int Count(const std::function<void()>& change)
  {
    const vtkMTimeType refined = this->Filter->GetOutput()->GetMTime();
    const vtkMTimeType tagged = this->Tagger->GetOutput()->GetMTime();
    const vtkMTimeType built = this->Locator->GetBuildTime();
    change();
    this->Filter->Update();
    this->Tagger->Update();
    this->Locator->BuildLocator();
    return (this->Filter->GetOutput()->GetMTime() != refined ? 1 : 0) +
      (this->Tagger->GetOutput()->GetMTime() != tagged ? 1 : 0) +
      (this->Locator->GetBuildTime() != built ? 1 : 0);
  }

  Mesh Input = Sphere(8, 6);
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkMatrix4x4> Place;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
  vtkNew<vtkRefinedCellLocator> Locator;
  vtkNew<vtkDepthTagFilter> Tagger;
};

void TestTimes(RelevoCheck& check)
{
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetRadius(0.3);
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMaximumDistance(5.0);
  const struct
  {
    vtkDepthTagMetric* Metric;
    bool OfCamera;
    bool OfPlace;
  } cases[] = { { curvature, false, false }, { region, false, true }, { distance, true, true } };
  Subjects subjects;
  for (const auto& each : cases)
  {
    subjects.SetMetric(each.Metric);
    CHECK_EQUAL(subjects.Count([] {}), 0);
    CHECK_EQUAL(subjects.Count([&] { subjects.Camera->Azimuth(10.0); }), (each.OfCamera ? 3 : 0));
    CHECK_EQUAL(
      subjects.Count([&] { subjects.Place->SetElement(0, 3, subjects.Place->GetMTime()); }),
      (each.OfPlace ? 3 : 0));
  }
  subjects.Recipe->SetMetric(nullptr);
  subjects.Count([] {});
  CHECK_EQUAL(subjects.Locator->GetViewportSize()[0], 400);
  const vtkMTimeType times[] = { subjects.Filter->GetMTime(), subjects.Locator->GetMTime() };
  subjects.Camera->Azimuth(10.0);
  CHECK(subjects.Filter->GetMTime() == times[0] && subjects.Locator->GetMTime() == times[1]);
}

// The tags for an actor's matrix are those of the transformed mesh.
void TestPlace(RelevoCheck& check)
{
  Subjects subjects;
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(4.0);
  subjects.SetMetric(metric);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.5, 1.0, -1.5);
  transform->RotateX(40.0);
  transform->Scale(1.5, 1.5, 1.5);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputData(subjects.Input);
  moved->SetTransform(transform);
  vtkNew<vtkDepthTagFilter> expected;
  expected->SetInputConnection(moved->GetOutputPort());
  expected->SetMetric(metric);
  expected->SetCamera(subjects.Camera);
  expected->SetViewportSize(400, 300);
  expected->Update();
  const auto getTags = [](vtkDepthTagFilter* filter)
  { return filter->GetOutput()->GetPointData()->GetArray("DepthTag"); };
  vtkNew<vtkFloatArray> unmoved;
  unmoved->DeepCopy(getTags(subjects.Tagger));
  subjects.Place->DeepCopy(transform->GetMatrix());
  subjects.Tagger->Update();
  double farthest = 0.0;
  for (vtkIdType point = 0; point < subjects.Input->GetNumberOfPoints(); ++point)
  {
    const double tag = getTags(subjects.Tagger)->GetTuple1(point);
    CHECK_NEAR(tag, getTags(expected)->GetTuple1(point), 1e-4);
    farthest = std::max(farthest, std::abs(tag - unmoved->GetTuple1(point)));
  }
  CHECK_GREATER(farthest, 0.1);
}
}

int TestViewSettings(int, char*[])
{
  RelevoCheck check;
  TestTimes(check);
  TestPlace(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDistanceDepthTagMetric against levels by hand.
#include "RelevoCheck.h"

#include "vtkCamera.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementView.h"
#include "vtkTransform.h"

#include <initializer_list>
#include <limits>
#include <vector>

namespace
{
vtkSmartPointer<vtkPolyData> MakePoints(
  std::initializer_list<std::vector<double>> coordinates, int type = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (const auto& x : coordinates)
  {
    points->InsertNextPoint(x.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  return mesh;
}
}

int TestDistanceDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkDistanceDepthTagMetric> metric;
  vtkNew<vtkFloatArray> tags;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 0);
  vtkRefinementView view;
  view.Camera = camera;
  CHECK(metric->IsViewDependent());
  CHECK(metric->GetMaximumDistance() == 0.0);

  // The mapping: MaximumLevel at the camera, 0 from MaximumDistance on, linear between.
  metric->SetMaximumDistance(5.0);
  auto mesh =
    MakePoints({ { 0, 0, 0 }, { 0, 1, 0 }, { 1.5, 0, -2 }, { 0, 0, 5 }, { 7, 0, 0 }, { 3, 4, 0 } });
  CHECK(metric->ComputeTags(mesh, view, 4, tags));
  CHECK(tags->GetNumberOfTuples() == 6 && tags->GetNumberOfComponents() == 1);
  const double levels[6] = { 4.0, 3.2, 2.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(tags->GetValue(i), levels[i], 1e-6);
  }
  CHECK(metric->ComputeTags(mesh, view, 0, tags));
  CHECK(tags->GetValue(0) == 0.0f);

  // Distances are the world's: (1, 0, 0) goes to (2, 0, 3).
  vtkNew<vtkTransform> transform;
  transform->Translate(0, 0, 3);
  transform->Scale(2, 2, 2);
  view.ModelToWorld = transform->GetMatrix();
  CHECK(metric->ComputeTags(MakePoints({ { 1, 0, 0 } }), view, 4, tags));
  CHECK_NEAR(tags->GetValue(0), 4.0 * (1.0 - std::sqrt(13.0) / 5.0), 1e-6);

  // Automatic: three diagonals of the box in world units, however the actor is turned.
  metric->SetMaximumDistance(0.0);
  auto box = MakePoints({ { 0, 0, 0 }, { 1, 2, 2 } });
  camera->SetPosition(0, 0, 9);
  for (double angle : { 0.0, 30.0 })
  {
    transform->Identity();
    transform->RotateX(angle);
    transform->RotateY(2 * angle);
    transform->Scale(2, 2, 2);
    view.ModelToWorld = transform->GetMatrix();
    CHECK(metric->ComputeTags(box, view, 5, tags));
    CHECK_NEAR(tags->GetValue(0), 5.0 * (1.0 - 9.0 / 18.0), 1e-6);
  }
  view.ModelToWorld = nullptr;
  // One point has no extent: nothing to refine, nothing to divide by.
  CHECK(metric->ComputeTags(MakePoints({ { 1, 1, 1 } }), view, 5, tags));
  CHECK(tags->GetValue(0) == 0.0f);

  // Points that are not finite get level 0 and do not disturb the others.
  auto broken = MakePoints(
    { { 0, 0, 0 }, { nan, 0, 0 }, { 0, infinity, 0 }, { 1, 2, 2 }, { 0, 0, -infinity } });
  CHECK(metric->ComputeTags(broken, view, 5, tags));
  CHECK(tags->GetValue(1) == 0.0f && tags->GetValue(2) == 0.0f && tags->GetValue(4) == 0.0f);
  const float first = tags->GetValue(0);
  CHECK(metric->ComputeTags(box, view, 5, tags));
  CHECK(first == tags->GetValue(0));
  auto huge = MakePoints({ { 0, 0, 0 }, { 1e300, 0, 0 }, { -1e300, 1e300, 0 } });
  CHECK(metric->ComputeTags(huge, view, 5, tags));
  for (vtkIdType i = 0; i < 3; ++i)
  {
    CHECK(tags->GetValue(i) >= 0.0f && tags->GetValue(i) <= 5.0f);
  }

  // Far from the origin distances keep their digits.
  metric->SetMaximumDistance(1.0);
  camera->SetPosition(5e6, 4e6, 100.0);
  CHECK(metric->ComputeTags(MakePoints({ { 5e6, 4e6, 100.25 } }), view, 4, tags));
  CHECK_NEAR(tags->GetValue(0), 3.0, 1e-6);

  // No points.
  vtkNew<vtkPolyData> empty;
  CHECK(metric->ComputeTags(empty, view, 4, tags));
  CHECK(tags->GetNumberOfTuples() == 0);

  // Errors.
  RelevoErrors errors(metric);
  for (double bad : { -1.0, infinity, nan })
  {
    const vtkMTimeType time = metric->GetMTime();
    metric->SetMaximumDistance(bad);
    CHECK(errors.Said("MaximumDistance"));
    CHECK(metric->GetMaximumDistance() == 1.0 && metric->GetMTime() == time);
  }
  view.Camera = nullptr;
  CHECK(!metric->ComputeTags(mesh, view, 4, tags));
  CHECK(errors.Said("no camera"));
  view.Camera = camera;
  camera->SetPosition(nan, 0, 0);
  CHECK(!metric->ComputeTags(mesh, view, 4, tags));
  CHECK(errors.Said("not finite"));

  const vtkMTimeType time = metric->GetMTime();
  metric->SetMaximumDistance(2.0);
  CHECK(metric->GetMTime() > time && errors.None());
  return check.GetResult();
}

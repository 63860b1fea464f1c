// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRegionDepthTagMetric against levels by hand.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkBox.h"
#include "vtkPlane.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkSphere.h"
#include "vtkTransform.h"

#include <limits>

namespace
{
// Points along x at 0, 1/4, 1/2 ... 3.
RelevoMeshes::Mesh Line()
{
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i <= 12; ++i)
  {
    points.push_back({ { 0.25 * i, 0, 0 } });
  }
  return RelevoMeshes::FromTriangles(points, {});
}

double Smooth(double distance, double fallOff)
{
  const double t = std::min(std::max(1.0 - distance / fallOff, 0.0), 1.0);
  return 3 * t * t - 2 * t * t * t;
}
}

int TestRegionDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  const double nan = std::nan("");
  vtkNew<vtkRegionDepthTagMetric> metric;
  CHECK(!metric->IsViewDependent());
  relevo::RefinementView view;
  auto mesh = Line();

  // A picked point.
  metric->SetRadius(0.5);
  metric->SetFallOff(2.0);
  auto tags = TagsOf(metric, mesh, view, 5);
  CHECK(tags.size() == 13);
  for (int i = 0; i <= 12; ++i)
  {
    CHECK_NEAR(tags[i], 5.0 * Smooth(0.25 * i - 0.5, 2.0), 1e-5);
    CHECK(i == 0 || tags[i] <= tags[i - 1]);
  }
  CHECK(tags[2] == 5.0f && tags[10] == 0.0f);
  // In world coordinates.
  vtkNew<vtkTransform> transform;
  transform->Translate(1, 0, 0);
  transform->Scale(2, 2, 2);
  view.ModelToWorld = transform->GetMatrix();
  CHECK_NEAR(TagsOf(metric, mesh, view, 5)[1], 5.0 * Smooth(1.0, 2.0), 1e-5);
  view.ModelToWorld = nullptr;
  // Automatic: a tenth of the diagonal of 3.
  metric->SetFallOff(0.0);
  metric->SetCenter(0.1, 0, 0);
  CHECK_NEAR(TagsOf(metric, mesh, view, 5)[3], 5.0 * Smooth(0.15, 0.3), 1e-4);
  // A region out of the mesh's reach.
  metric->SetCenter(50, 0, 0);
  CHECK(TagsOf(metric, mesh, view, 5) == std::vector<float>(13, 0.0f));

  // Functions: a plane, x <= 1, whose gradient may be of any length; a box.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1, 0, 0);
  plane->SetNormal(1, 0, 0);
  metric->SetImplicitFunction(plane);
  metric->SetFallOff(1.5);
  tags = TagsOf(metric, mesh, view, 4);
  for (int i = 0; i <= 12; ++i)
  {
    CHECK_NEAR(tags[i], 4.0 * Smooth(0.25 * i - 1.0, 1.5), 1e-5);
  }
  const vtkMTimeType time = metric->GetMTime();
  plane->SetOrigin(2, 0, 0);
  CHECK(metric->GetMTime() > time);
  CHECK(TagsOf(metric, mesh, view, 4)[8] == 4.0f);
  vtkNew<vtkBox> box;
  box->SetBounds(-1, 1, -1, 1, -1, 1);
  metric->SetImplicitFunction(box);
  CHECK_NEAR(TagsOf(metric, mesh, view, 4)[6], 4.0 * Smooth(0.5, 1.5), 1e-5);
  // A sphere's function is no distance: to the first order it is, (r^2 - 1) / (2 r) for r - 1.
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(1.0);
  metric->SetImplicitFunction(sphere);
  CHECK_NEAR(TagsOf(metric, mesh, view, 4)[5], 4.0 * Smooth(0.225, 1.5), 1e-5);
  // A plane without a normal: 0 is inside.
  plane->SetNormal(0, 0, 0);
  metric->SetImplicitFunction(plane);
  CHECK(AreLevels(TagsOf(metric, mesh, view, 4), 13, 4));
  metric->SetImplicitFunction(sphere);
  CHECK(SurvivesOddMeshes(metric));
  metric->SetImplicitFunction(nullptr);
  metric->SetCenter(0, 0, 0);
  CHECK(SurvivesOddMeshes(metric));
  auto broken = RelevoMeshes::FromTriangles({ { { nan, 0, 0 } }, { { 0, 0, 0 } } }, {});
  tags = TagsOf(metric, broken, view, 5);
  CHECK(tags[0] == 0.0f && tags[1] == 5.0f);

  // Errors.
  RelevoErrors errors(metric);
  for (double bad : { -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    metric->SetRadius(bad);
    CHECK(errors.Said("Radius") && metric->GetRadius() == 0.5);
    metric->SetFallOff(bad);
    CHECK(errors.Said("FallOff") && metric->GetFallOff() == 1.5);
  }
  metric->SetCenter(0, nan, 0);
  CHECK(errors.Said("Center") && metric->GetCenter()[1] == 0.0);
  metric->SetRadius(0.0);
  CHECK(TagsOf(metric, mesh, view, 5).empty() && errors.Said("no region"));
  return check.GetResult();
}

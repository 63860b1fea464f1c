// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRegionDepthTagMetric promises levels by the distance from a ball or an implicit function,
// compared with values computed by hand.
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

const double NaN = std::nan("");

// A line of points, and a ball around the origin.
struct Scene
{
  Scene()
  {
    this->Metric->SetRadius(0.5);
    this->Metric->SetFallOff(2.0);
  }
  std::vector<float> GetTags(int maximumLevel)
  {
    return TagsOf(this->Metric, this->Mesh, this->View, maximumLevel);
  }

  vtkNew<vtkRegionDepthTagMetric> Metric;
  relevo::RefinementView View;
  RelevoMeshes::Mesh Mesh = Line();
};

// The ball around a picked point.
void TestBall(RelevoCheck& check)
{
  Scene scene;
  CHECK(!scene.Metric->IsViewDependent());
  const auto tags = scene.GetTags(5);
  CHECK_EQUAL(tags.size(), 13);
  for (int i = 0; i <= 12; ++i)
  {
    CHECK_NEAR(tags[i], 5.0 * Smooth(0.25 * i - 0.5, 2.0), 1e-5);
    CHECK(i == 0 || tags[i] <= tags[i - 1]);
  }
  CHECK(tags[2] == 5.0f && tags[10] == 0.0f);
  // The region is in world coordinates.
  vtkNew<vtkTransform> transform;
  transform->Translate(1, 0, 0);
  transform->Scale(2, 2, 2);
  scene.View.ModelToWorld = transform->GetMatrix();
  CHECK_NEAR(scene.GetTags(5)[1], 5.0 * Smooth(1.0, 2.0), 1e-5);
  scene.View.ModelToWorld = nullptr;
  // The automatic fall-off is a tenth of the diagonal, which is 3.
  scene.Metric->SetFallOff(0.0);
  scene.Metric->SetCenter(0.1, 0, 0);
  CHECK_NEAR(scene.GetTags(5)[3], 5.0 * Smooth(0.15, 0.3), 1e-4);
  // The region is too far from the mesh to have an effect.
  scene.Metric->SetCenter(50, 0, 0);
  CHECK_EQUAL(scene.GetTags(5), std::vector<float>(13, 0.0f));
}

// Functions: the plane x <= 1 with gradients of any length, and a box.
void TestFunctions(RelevoCheck& check)
{
  Scene scene;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1, 0, 0);
  plane->SetNormal(1, 0, 0);
  scene.Metric->SetImplicitFunction(plane);
  scene.Metric->SetFallOff(1.5);
  const auto tags = scene.GetTags(4);
  for (int i = 0; i <= 12; ++i)
  {
    CHECK_NEAR(tags[i], 4.0 * Smooth(0.25 * i - 1.0, 1.5), 1e-5);
  }
  const vtkMTimeType time = scene.Metric->GetMTime();
  plane->SetOrigin(2, 0, 0);
  CHECK_GREATER(scene.Metric->GetMTime(), time);
  CHECK_EQUAL(scene.GetTags(4)[8], 4.0f);
  vtkNew<vtkBox> box;
  box->SetBounds(-1, 1, -1, 1, -1, 1);
  scene.Metric->SetImplicitFunction(box);
  CHECK_NEAR(scene.GetTags(4)[6], 4.0 * Smooth(0.5, 1.5), 1e-5);
  // A sphere's function is not a distance, but the first-order estimate is (r^2 - 1) / (2 r) for r
  // - 1.
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(1.0);
  scene.Metric->SetImplicitFunction(sphere);
  CHECK_NEAR(scene.GetTags(4)[5], 4.0 * Smooth(0.225, 1.5), 1e-5);
  // A plane without a normal has the value 0 everywhere, so all points are inside.
  plane->SetNormal(0, 0, 0);
  scene.Metric->SetImplicitFunction(plane);
  CHECK(AreLevels(scene.GetTags(4), 13, 4));
}

void TestOddMeshes(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetFallOff(1.5);
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(1.0);
  scene.Metric->SetImplicitFunction(sphere);
  CHECK(SurvivesOddMeshes(scene.Metric));
  scene.Metric->SetImplicitFunction(nullptr);
  scene.Metric->SetCenter(0, 0, 0);
  CHECK(SurvivesOddMeshes(scene.Metric));
  scene.Mesh = RelevoMeshes::FromTriangles({ { { NaN, 0, 0 } }, { { 0, 0, 0 } } }, {});
  const auto tags = scene.GetTags(5);
  CHECK(tags[0] == 0.0f && tags[1] == 5.0f);
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  vtkRegionDepthTagMetric* metric = scene.Metric;
  metric->SetFallOff(1.5);
  RelevoErrors errors(metric);
  for (double bad : { -1.0, NaN, std::numeric_limits<double>::infinity() })
  {
    CHECK_CASE(bad);
    metric->SetRadius(bad);
    CHECK(errors.Said("Radius") && metric->GetRadius() == 0.5);
    metric->SetFallOff(bad);
    CHECK(errors.Said("FallOff") && metric->GetFallOff() == 1.5);
  }
  metric->SetCenter(0, NaN, 0);
  CHECK(errors.Said("Center") && metric->GetCenter()[1] == 0.0);
  metric->SetRadius(0.0);
  CHECK(scene.GetTags(5).empty() && errors.Said("no region"));
}
}

int TestRegionDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestBall(check);
  TestFunctions(check);
  TestOddMeshes(check);
  TestErrors(check);
  return check.GetResult();
}

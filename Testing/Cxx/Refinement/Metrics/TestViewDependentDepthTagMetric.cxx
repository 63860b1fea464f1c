// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkViewDependentDepthTagMetric promises levels by the spread of normals and the view direction,
// compared with values computed by hand. Levels rise with both.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <cmath>

namespace
{
// An apex over a square with faces of slope `slope` in radians, which is the spread of normals at
// point 0.
RelevoMeshes::Mesh Pyramid(double slope)
{
  const double h = std::tan(slope);
  return RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 1, -h } }, { { -1, 1, -h } }, { { -1, -1, -h } }, { { 1, -1, -h } } },
    { { { 0, 1, 2 } }, { { 0, 2, 3 } }, { { 0, 3, 4 } }, { { 0, 4, 1 } } });
}

// A metric and a camera that looks at the origin.
struct Scene
{
  Scene()
  {
    this->Camera->SetFocalPoint(0, 0, 0);
    this->View.Camera = this->Camera;
  }
  std::vector<float> GetTags(vtkPolyData* mesh, int maximumLevel)
  {
    return TagsOf(this->Metric, mesh, this->View, maximumLevel);
  }

  vtkNew<vtkViewDependentDepthTagMetric> Metric;
  vtkNew<vtkCamera> Camera;
  relevo::RefinementView View;
};

// Pyramids seen from all sides, at several scales.
void TestPyramids(RelevoCheck& check, Scene& scene, double weight, double scale)
{
  float ofView = -1.0f;
  for (double turn = 0.0; turn <= 90.0; turn += 10.0)
  {
    const double angle = vtkMath::RadiansFromDegrees(turn);
    scene.Camera->SetPosition(7 * scale * std::sin(angle), 0, 7 * scale * std::cos(angle));
    float ofSpread = -1.0f;
    for (double slope = 0.0; slope <= 40.0; slope += 5.0)
    {
      const double none[3] = { 0, 0, 0 };
      auto mesh =
        RelevoMeshes::Moved(Pyramid(vtkMath::RadiansFromDegrees(slope)), scale, none, VTK_DOUBLE);
      const auto tags = scene.GetTags(mesh, 6);
      const double expected =
        std::min(1.0, slope / 30.0 * (1.0 - weight + weight * (1.0 - std::abs(std::cos(angle)))));
      CHECK_NEAR(tags[0], 6.0 * expected, 1e-4);
      CHECK_GREATER_EQUAL(tags[0], ofSpread - 1e-5f);
      ofSpread = tags[0];
      if (slope == 20.0)
      {
        CHECK_GREATER_EQUAL(tags[0], ofView - 1e-5f);
        CHECK(weight == 0.0 || turn == 0.0 || tags[0] > ofView);
        ofView = tags[0];
      }
    }
  }
}

void TestSpreadAndView(RelevoCheck& check)
{
  Scene scene;
  CHECK(scene.Metric->IsViewDependent());
  CHECK_EQUAL(scene.Metric->GetMaximumSpread(), 30.0);
  CHECK_EQUAL(scene.Metric->GetEdgeOnWeight(), 0.5);
  for (double weight : { 0.0, 0.5, 1.0 })
  {
    CHECK_CASE(weight);
    scene.Metric->SetEdgeOnWeight(weight);
    for (bool parallel : { false, true })
    {
      CHECK_CASE(parallel);
      scene.Camera->SetParallelProjection(parallel);
      for (double scale : { 1e-6, 1.0, 1e6 })
      {
        CHECK_CASE(scale);
        TestPyramids(check, scene, weight, scale);
      }
    }
  }
}

// Flat meshes have level 0 in every view. With random cameras, a larger MaximumSpread never gives
// higher levels.
void TestRandomCameras(RelevoCheck& check)
{
  Scene scene;
  std::mt19937 random(4);
  auto plane = RelevoMeshes::Plane(4, 4);
  auto sphere = RelevoMeshes::Sphere(12, 9);
  auto exploded = RelevoMeshes::Explode(sphere);
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 100; ++i)
  {
    PlaceAtRandom(scene.Camera, random);
    scene.Metric->SetMaximumSpread(20.0);
    for (float tag : scene.GetTags(plane, 5))
    {
      CHECK_LESS(tag, 1e-3f);
    }
    const auto tags = scene.GetTags(sphere, 5);
    CHECK(AreLevels(tags, sphere->GetNumberOfPoints(), 5));
    // Coincident points share their tag.
    const auto ofExploded = scene.GetTags(exploded, 5);
    for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
    {
      sphere->GetCellPoints(cell, ids);
      for (int corner = 0; corner < 3; ++corner)
      {
        CHECK_NEAR(ofExploded[3 * cell + corner], tags[ids->GetId(corner)], 1e-4);
      }
    }
    scene.Metric->SetMaximumSpread(40.0);
    const auto less = scene.GetTags(sphere, 5);
    for (std::size_t point = 0; point < tags.size(); ++point)
    {
      CHECK_LESS_EQUAL(less[point], tags[point]);
    }
  }
}

// The eye at the apex, and a fold whose normals cancel.
void TestOddMeshes(RelevoCheck& check)
{
  Scene scene;
  scene.Camera->SetPosition(0, 0, 0);
  scene.Camera->SetFocalPoint(0, 0, -1);
  CHECK_NEAR(scene.GetTags(Pyramid(vtkMath::RadiansFromDegrees(15.0)), 6)[0], 3.0, 1e-4);
  auto fold = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } }, { { 0, 2, 1 } } });
  CHECK_EQUAL(scene.GetTags(fold, 6)[0], 6.0f);
  CHECK(SurvivesOddMeshes(scene.Metric));
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  vtkViewDependentDepthTagMetric* metric = scene.Metric;
  RelevoErrors errors(metric);
  for (double bad : { 0.0, -1.0, 181.0, std::nan("") })
  {
    CHECK_CASE(bad);
    metric->SetMaximumSpread(bad);
    CHECK(errors.Said("MaximumSpread") && metric->GetMaximumSpread() == 30.0);
  }
  for (double bad : { -0.1, 1.1, std::nan("") })
  {
    CHECK_CASE(bad);
    metric->SetEdgeOnWeight(bad);
    CHECK(errors.Said("EdgeOnWeight") && metric->GetEdgeOnWeight() == 0.5);
  }
  auto plane = RelevoMeshes::Plane(4, 4);
  scene.Camera->SetPosition(1, 2, 3);
  scene.Camera->SetFocalPoint(1, 2, 3);
  CHECK(scene.GetTags(plane, 5).empty() && errors.Said("no direction"));
  scene.View.Camera = nullptr;
  CHECK(scene.GetTags(plane, 5).empty() && errors.Said("no camera"));
}
}

int TestViewDependentDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestSpreadAndView(check);
  TestRandomCameras(check);
  TestOddMeshes(check);
  TestErrors(check);
  return check.GetResult();
}

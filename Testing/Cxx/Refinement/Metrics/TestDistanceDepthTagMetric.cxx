// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDistanceDepthTagMetric promises levels by its formulae, compared with values computed by hand.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
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

// An equilateral triangle with this side, around the z axis at height z.
RelevoMeshes::Mesh MakeTriangle(double side, double z)
{
  const double r = side / std::sqrt(3.0);
  return RelevoMeshes::FromTriangles(
    { { { r, 0, z } }, { { -0.5 * r, 0.5 * side, z } }, { { -0.5 * r, -0.5 * side, z } } },
    { { { 0, 1, 2 } } });
}

void TestProjectedSize(RelevoCheck& check)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  CHECK_EQUAL(metric->GetFallOff(), vtkDistanceDepthTagMetric::LINEAR);
  metric->SetFallOffToProjectedSize();
  CHECK_EQUAL(std::string(metric->GetFallOffAsString()), "ProjectedSize");
  metric->SetMaximumDistance(8.0);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(0, 0, -1);
  relevo::RefinementView view;
  view.Camera = camera;
  // Each time the distance halves, from 8 on, the level rises by one, up to the maximum at the
  // camera.
  auto points = MakePoints({ { 9, 0, 0 }, { 8, 0, 0 }, { 0, 6, 0 }, { 0, 0, 4 }, { 0, -2, 0 },
    { 0.3, 0, 0 }, { 0.01, 0, 0 }, { 0, 0, 0 } });
  auto tags = TagsOf(metric, points, view, 5);
  const double levels[] = { 0, 0, std::log2(8.0 / 6.0), 1, 2, std::log2(8.0 / 0.3), 5, 5 };
  for (int i = 0; i < 8; ++i)
  {
    CHECK_NEAR(tags[i], levels[i], 1e-6);
  }

  // With ReferenceLength, a side of the mean length, seen from the front, has segments of that many
  // pixels, as projected by vtkCamera.
  metric->SetMaximumDistance(0.0);
  metric->SetReferenceLength(12.5);
  camera->SetClippingRange(0.01, 1000.0);
  for (double angle : { 20.0, 90.0 })
  {
    for (bool across : { false, true })
    {
      for (double scale : { 1.0, 3.0 })
      {
        camera->SetViewAngle(angle);
        camera->SetUseHorizontalViewAngle(across);
        view.ViewportSize[0] = 700;
        view.ViewportSize[1] = 500;
        vtkNew<vtkTransform> transform;
        transform->RotateZ(40);
        transform->Scale(scale, scale, scale);
        view.ModelToWorld = transform->GetMatrix();
        auto triangle = MakeTriangle(0.5, -3.0);
        const double distance = 3.0 * scale;
        vtkMatrix4x4* toClip = camera->GetCompositeProjectionTransformMatrix(1.4, -1, 1);
        double x[4] = { 0, 0.5 * scale, -std::sqrt(9.0 + 0.25 / 3.0) * scale, 1 };
        CHECK_GREATER_EQUAL(-x[2], distance);
        toClip->MultiplyPoint(x, x);
        const double pixels = 0.5 * 500 * x[1] / x[3];
        tags = TagsOf(metric, triangle, view, 7);
        CHECK_NEAR(tags[0], std::max(0.0, std::log2(pixels / 12.5)), 1e-5);
        // The same distance has another level with linear fall-off.
        metric->SetFallOffToLinear();
        CHECK_NEAR(
          TagsOf(metric, triangle, view, 7)[0], 7.0 * std::max(0.0, 1.0 - 12.5 / pixels), 1e-5);
        metric->SetFallOffToProjectedSize();
      }
    }
  }
  view.ModelToWorld = nullptr;
  // A mesh without edges has nothing to refine.
  CHECK_EQUAL(TagsOf(metric, points, view, 5), std::vector<float>(8, 0.0f));

  RelevoErrors errors(metric);
  for (double bad : { -1.0, 1e-9, 1e9, std::nan("") })
  {
    CHECK_CASE(bad);
    metric->SetReferenceLength(bad);
    CHECK(errors.Said("ReferenceLength") && metric->GetReferenceLength() == 12.5);
  }
  metric->SetFallOff(2);
  CHECK(errors.Said("FallOff") && metric->GetFallOff() == 1);
  view.ViewportSize[0] = 0;
  CHECK(TagsOf(metric, points, view, 5).empty() && errors.Said("no pixels"));
  metric->SetReferenceLength(0.0);
  CHECK(TagsOf(metric, points, view, 5).size() == 8 && errors.None());
}

void TestCentroids(RelevoCheck& check)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(10.0);
  metric->SetMeasureToCentroids();
  CHECK_EQUAL(std::string(metric->GetMeasureAsString()), "Centroids");
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
  view.Camera = camera;
  std::mt19937 random(2);
  auto sphere = RelevoMeshes::Explode(RelevoMeshes::Sphere(9, 7));
  const relevo::SurfaceEdges edges(sphere);
  const relevo::SurfaceTriangles& surface = edges.GetTriangles();
  for (int i = 0; i < 5; ++i)
  {
    PlaceAtRandom(camera, random);
    // The level follows the closest centroid among the triangles at a merged point, or among those
    // at an edge.
    std::vector<double> ofMergedPoints(sphere->GetNumberOfPoints(), 0.0);
    std::vector<double> ofEdges(edges.GetNumberOfEdges(), 0.0);
    for (const auto& triangle : surface.GetTriangles())
    {
      double centroid[3] = { 0, 0, 0 };
      for (vtkIdType corner : triangle)
      {
        for (int c = 0; c < 3; ++c)
        {
          centroid[c] += sphere->GetPoint(corner)[c] / 3.0;
        }
      }
      const double distance =
        std::sqrt(vtkMath::Distance2BetweenPoints(centroid, camera->GetPosition()));
      const double level = std::max(0.0, 5.0 * (1.0 - distance / 10.0));
      for (int corner = 0; corner < 3; ++corner)
      {
        double& ofPlace = ofMergedPoints[triangle[corner]];
        ofPlace = std::max(ofPlace, level);
        double& ofEdge = ofEdges[edges.FindEdge(triangle[corner], triangle[(corner + 1) % 3])];
        ofEdge = std::max(ofEdge, level);
      }
    }
    const auto tags = TagsOf(metric, sphere, view, 5);
    for (std::size_t point = 0; point < tags.size(); ++point)
    {
      CHECK_NEAR(
        tags[point], ofMergedPoints[surface.GetMergedPoint(static_cast<vtkIdType>(point))], 1e-5);
    }
    const auto edgeTags = EdgeTagsOf(metric, sphere, view, 5, edges);
    for (std::size_t edge = 0; edge < edgeTags.size(); ++edge)
    {
      CHECK_NEAR(edgeTags[edge], ofEdges[edge], 1e-5);
    }
  }
  CHECK(SurvivesOddMeshes(metric));
  RelevoErrors errors(metric);
  metric->SetMeasure(3);
  CHECK(errors.Said("Measure") && metric->GetMeasure() == 1);
}

const double Infinity = std::numeric_limits<double>::infinity();
const double NaN = std::numeric_limits<double>::quiet_NaN();

// A metric, a camera at the origin, and the tags of the last mesh.
struct Scene
{
  Scene()
  {
    this->Camera->SetPosition(0, 0, 0);
    this->View.Camera = this->Camera;
  }
  bool Compute(vtkPolyData* mesh, int maximumLevel)
  {
    return this->Metric->ComputeTags(mesh, this->View, maximumLevel, this->Tags);
  }

  vtkNew<vtkDistanceDepthTagMetric> Metric;
  vtkNew<vtkFloatArray> Tags;
  vtkNew<vtkCamera> Camera;
  relevo::RefinementView View;
};

vtkSmartPointer<vtkPolyData> MakeSixPoints()
{
  return MakePoints(
    { { 0, 0, 0 }, { 0, 1, 0 }, { 1.5, 0, -2 }, { 0, 0, 5 }, { 7, 0, 0 }, { 3, 4, 0 } });
}

// Levels are MaximumLevel at the camera, 0 from MaximumDistance on, and linear between.
void TestLinear(RelevoCheck& check)
{
  Scene scene;
  CHECK(scene.Metric->IsViewDependent());
  CHECK_EQUAL(scene.Metric->GetMaximumDistance(), 0.0);

  scene.Metric->SetMaximumDistance(5.0);
  auto mesh = MakeSixPoints();
  CHECK(scene.Compute(mesh, 4));
  CHECK_EQUAL(scene.Tags->GetNumberOfTuples(), 6);
  CHECK_EQUAL(scene.Tags->GetNumberOfComponents(), 1);
  const double levels[6] = { 4.0, 3.2, 2.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(scene.Tags->GetValue(i), levels[i], 1e-6);
  }
  CHECK(scene.Compute(mesh, 0));
  CHECK_EQUAL(scene.Tags->GetValue(0), 0.0f);
}

// Distances are in world coordinates: (1, 0, 0) moves to (2, 0, 3).
void TestWorld(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMaximumDistance(5.0);
  vtkNew<vtkTransform> transform;
  transform->Translate(0, 0, 3);
  transform->Scale(2, 2, 2);
  scene.View.ModelToWorld = transform->GetMatrix();
  CHECK(scene.Compute(MakePoints({ { 1, 0, 0 } }), 4));
  CHECK_NEAR(scene.Tags->GetValue(0), 4.0 * (1.0 - std::sqrt(13.0) / 5.0), 1e-6);
}

// The automatic distance is three diagonals of the bounding box in world units, whatever the
// actor's orientation.
void TestAutomatic(RelevoCheck& check)
{
  Scene scene;
  scene.Camera->SetPosition(0, 0, 9);
  auto box = MakePoints({ { 0, 0, 0 }, { 1, 2, 2 } });
  vtkNew<vtkTransform> transform;
  for (double angle : { 0.0, 30.0 })
  {
    CHECK_CASE(angle);
    transform->Identity();
    transform->RotateX(angle);
    transform->RotateY(2 * angle);
    transform->Scale(2, 2, 2);
    scene.View.ModelToWorld = transform->GetMatrix();
    CHECK(scene.Compute(box, 5));
    CHECK_NEAR(scene.Tags->GetValue(0), 5.0 * (1.0 - 9.0 / 18.0), 1e-6);
  }
  scene.View.ModelToWorld = nullptr;
  // A single point has no extent, which must not cause a division by zero.
  CHECK(scene.Compute(MakePoints({ { 1, 1, 1 } }), 5));
  CHECK_EQUAL(scene.Tags->GetValue(0), 0.0f);
}

// Points that are not finite get level 0 and do not affect others.
void TestBrokenPoints(RelevoCheck& check)
{
  Scene scene;
  scene.Camera->SetPosition(0, 0, 9);
  auto broken = MakePoints(
    { { 0, 0, 0 }, { NaN, 0, 0 }, { 0, Infinity, 0 }, { 1, 2, 2 }, { 0, 0, -Infinity } });
  CHECK(scene.Compute(broken, 5));
  const float first = scene.Tags->GetValue(0);
  CHECK_EQUAL(scene.Tags->GetValue(1), 0.0f);
  CHECK_EQUAL(scene.Tags->GetValue(2), 0.0f);
  CHECK_EQUAL(scene.Tags->GetValue(4), 0.0f);
  CHECK(scene.Compute(MakePoints({ { 0, 0, 0 }, { 1, 2, 2 } }), 5));
  CHECK_EQUAL(first, scene.Tags->GetValue(0));
  auto huge = MakePoints({ { 0, 0, 0 }, { 1e300, 0, 0 }, { -1e300, 1e300, 0 } });
  CHECK(scene.Compute(huge, 5));
  for (vtkIdType i = 0; i < 3; ++i)
  {
    CHECK_GREATER_EQUAL(scene.Tags->GetValue(i), 0.0f);
    CHECK_LESS_EQUAL(scene.Tags->GetValue(i), 5.0f);
  }
}

// Far from the origin, distances stay accurate. A mesh without points has no tags.
void TestFarAndEmpty(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMaximumDistance(1.0);
  scene.Camera->SetPosition(5e6, 4e6, 100.0);
  CHECK(scene.Compute(MakePoints({ { 5e6, 4e6, 100.25 } }), 4));
  CHECK_NEAR(scene.Tags->GetValue(0), 3.0, 1e-6);

  vtkNew<vtkPolyData> empty;
  CHECK(scene.Compute(empty, 4));
  CHECK_EQUAL(scene.Tags->GetNumberOfTuples(), 0);
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMaximumDistance(1.0);
  RelevoErrors errors(scene.Metric);
  for (double bad : { -1.0, Infinity, NaN })
  {
    CHECK_CASE(bad);
    const vtkMTimeType time = scene.Metric->GetMTime();
    scene.Metric->SetMaximumDistance(bad);
    CHECK(errors.Said("MaximumDistance"));
    CHECK_EQUAL(scene.Metric->GetMaximumDistance(), 1.0);
    CHECK_EQUAL(scene.Metric->GetMTime(), time);
  }
  auto mesh = MakeSixPoints();
  scene.View.Camera = nullptr;
  CHECK(!scene.Compute(mesh, 4));
  CHECK(errors.Said("no camera"));
  scene.View.Camera = scene.Camera;
  scene.Camera->SetPosition(NaN, 0, 0);
  CHECK(!scene.Compute(mesh, 4));
  CHECK(errors.Said("not finite"));

  const vtkMTimeType time = scene.Metric->GetMTime();
  scene.Metric->SetMaximumDistance(2.0);
  CHECK(scene.Metric->GetMTime() > time && errors.None());
}
}

int TestDistanceDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestProjectedSize(check);
  TestCentroids(check);
  TestLinear(check);
  TestWorld(check);
  TestAutomatic(check);
  TestBrokenPoints(check);
  TestFarAndEmpty(check);
  TestErrors(check);
  return check.GetResult();
}

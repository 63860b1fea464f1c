// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkScreenEdgeDepthTagMetric promises levels by the projected lengths of edges, compared with
// values computed by hand.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkIdList.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
struct Scene : FrontView
{
  // In a parallel projection, too, one unit covers 100 pixels.
  Scene() { this->Camera->SetParallelScale(2.0); }
  std::vector<float> GetTags(vtkPolyData* mesh, int maximumLevel)
  {
    return TagsOf(this->Metric, mesh, this->View, maximumLevel);
  }
  // The tag of the first point.
  float GetTag(vtkPolyData* mesh, int maximumLevel) { return this->GetTags(mesh, maximumLevel)[0]; }

  vtkNew<vtkScreenEdgeDepthTagMetric> Metric;
};

// The edges of point 0 have lengths 0.8 and 0.6; that between 1 and 2 has length 1. Point 3 has no
// edge.
RelevoMeshes::Mesh MakeTriangle()
{
  return RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0.8, 0, 0 } }, { { 0, 0.6, 0 } }, { { 9, 9, 9 } } },
    { { { 0, 1, 2 } } });
}

// The same triangle behind the eye.
RelevoMeshes::Mesh MakeTriangleBehind()
{
  return RelevoMeshes::FromTriangles(
    { { { 0, 0, 5 } }, { { 0.8, 0, 5 } }, { { 0, 0.6, 5 } } }, { { { 0, 1, 2 } } });
}

void TestLengths(RelevoCheck& check)
{
  Scene scene;
  CHECK(scene.Metric->IsViewDependent() && scene.Metric->GetReferenceLength() == 10.0);
  auto mesh = MakeTriangle();
  const auto tags = scene.GetTags(mesh, 6);
  CHECK_EQUAL(tags.size(), 4);
  CHECK_NEAR(tags[0], 3.0, 1e-5);
  CHECK_NEAR(tags[1], std::log2(10.0), 1e-5);
  CHECK_NEAR(tags[2], std::log2(10.0), 1e-5);
  CHECK_EQUAL(tags[3], 0.0f);
  scene.Metric->SetReferenceLength(20.0);
  CHECK_NEAR(scene.GetTag(mesh, 6), 2.0, 1e-5);
  CHECK_EQUAL(scene.GetTags(mesh, 2)[1], 2.0f);
  scene.Metric->SetReferenceLength(100.5);
  CHECK_EQUAL(scene.GetTags(mesh, 6)[1], 0.0f);
}

// The actor's matrix and the window's size take effect.
void TestMatrixAndViewport(RelevoCheck& check)
{
  Scene scene;
  auto mesh = MakeTriangle();
  vtkNew<vtkTransform> transform;
  transform->Scale(2, 2, 2);
  scene.View.ModelToWorld = transform->GetMatrix();
  CHECK_NEAR(scene.GetTag(mesh, 6), 4.0, 1e-5);
  scene.View.ModelToWorld = nullptr;
  scene.View.ViewportSize[0] = 1280;
  scene.View.ViewportSize[1] = 800;
  CHECK_NEAR(scene.GetTag(mesh, 6), 4.0, 1e-5);
  scene.View.ViewportSize[0] = 200; // only the window's height decides the scale
  CHECK_NEAR(scene.GetTag(mesh, 6), 4.0, 1e-5);
}

// With SphereDiameter the level does not depend on the edge's direction: it is that of an edge seen
// from the side, or length over distance, even behind the eye. The spheres of the edges from point
// 0 to 1 and to 2 lie beside the centre of the view.
void TestSpheres(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMeasureToSphereDiameter();
  CHECK_NEAR(scene.GetTag(MakeTriangle(), 6),
    std::log2(0.8 * 200.0 / std::sqrt(4.0 + 0.4 * 0.4) / 10.0), 1e-5);
  auto endOn = RelevoMeshes::FromTriangles({ { { 0, 0, 1 } }, { { 0, 0, -1 } }, { { 0, 1e-3, -1 } },
                                             { { 0, 0, 3 } }, { { 0, 0, 5 } }, { { 0, 1e-3, 5 } } },
    { { { 0, 1, 2 } }, { { 3, 4, 5 } } });
  const auto tags = scene.GetTags(endOn, 6);
  CHECK_NEAR(tags[0], std::log2(2.0 * 200.0 / 2.0 / 10.0), 1e-3);
  CHECK_NEAR(tags[3], std::log2(2.0 * 200.0 / 2.0 / 10.0), 1e-3);
  scene.Camera->SetPosition(0, 0, 0.9); // inside the sphere of the edge
  CHECK_NEAR(scene.GetTag(endOn, 7), std::log2(2.0 * 200.0 / 1.0 / 10.0), 1e-3);
  scene.Camera->SetPosition(0, 0, 2);
  scene.Camera->ParallelProjectionOn();
  CHECK_NEAR(scene.GetTag(endOn, 6), std::log2(2.0 * 100.0 / 10.0), 1e-3);
  scene.Camera->ParallelProjectionOff();
  scene.Metric->SetMeasureToProjectedLength();
  CHECK_EQUAL(scene.GetTags(endOn, 6)[3], 0.0f);
  RelevoErrors errors(scene.Metric);
  scene.Metric->SetMeasure(2);
  CHECK(errors.Said("must be one of PROJECTED_LENGTH (0), SPHERE_DIAMETER (1)"));
}

// A height of 2 * 2 units covers 400 pixels, even behind the eye.
void TestParallel(RelevoCheck& check)
{
  Scene scene;
  scene.Camera->ParallelProjectionOn();
  CHECK_NEAR(scene.GetTag(MakeTriangle(), 6), 3.0, 1e-5);
  CHECK_NEAR(scene.GetTag(MakeTriangleBehind(), 6), 3.0, 1e-5);
}

// Edges behind the eye have no length. Others are clipped at the near plane.
void TestPerspective(RelevoCheck& check)
{
  Scene scene;
  CHECK_EQUAL(scene.GetTag(MakeTriangleBehind(), 6), 0.0f);
  // The edge leads from 1 below the axis at the eye's depth to 1 below it at depth 4. Its part
  // beyond depth 1 projects to the range from 1 to 1/4 of half the height: 150 pixels.
  scene.Camera->SetClippingRange(1.0, 100.0);
  auto across = RelevoMeshes::FromTriangles(
    { { { 0, -1, 2 } }, { { 0, -1, -2 } }, { { 0, -1.001, 2 } } }, { { { 0, 1, 2 } } });
  scene.Metric->SetReferenceLength(0.01);
  CHECK_NEAR(std::exp2(scene.GetTag(across, 20)), 15000.0, 10.0);
  scene.Metric->SetReferenceLength(1.0);
  // An edge through the eye along the axis projects to a single point.
  auto axis = RelevoMeshes::FromTriangles(
    { { { 0, 0, 4 } }, { { 0, 0, 0 } }, { { 0, 1e-9, 4 } } }, { { { 0, 1, 2 } } });
  CHECK(AreLevels(scene.GetTags(axis, 5), 3, 5));
  CHECK_LESS(scene.GetTags(axis, 5)[1], 0.1f);
}

void TestFarFromOrigin(RelevoCheck& check)
{
  Scene scene;
  scene.Camera->SetPosition(5e6, 4e6, 2);
  scene.Camera->SetFocalPoint(5e6, 4e6, 0);
  auto corner = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0.75, 0, 0 } }, { { 0, 0.5, 0 } } }, { { { 0, 1, 2 } } });
  const double offset[3] = { 5e6, 4e6, 0 };
  auto far = RelevoMeshes::Moved(corner, 1.0, offset, VTK_DOUBLE);
  CHECK_NEAR(scene.GetTag(far, 6), std::log2(7.5), 1e-4);
}

// Tests all lengths up to 2^7 segments, with one pixel per unit.
void TestLogarithm(RelevoCheck& check)
{
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  vtkNew<vtkCamera> above;
  above->ParallelProjectionOn();
  above->SetParallelScale(256);
  relevo::RefinementView pixels;
  pixels.Camera = above;
  pixels.ViewportSize[0] = pixels.ViewportSize[1] = 512;
  metric->SetReferenceLength(1.0);
  float last = 0.0f;
  for (double length = 0.9; length < 140.0; length *= 1.003)
  {
    auto single = RelevoMeshes::FromTriangles(
      { { { 0, 0, 0 } }, { { length, 0, 0 } }, { { 0.5 * length, 0.1 * length, 0 } } },
      { { { 0, 1, 2 } } });
    const float tag = TagsOf(metric, single, pixels, 7)[0];
    CHECK_NEAR(tag, std::min(std::max(std::log2(length), 0.0), 7.0), 2e-6);
    CHECK_GREATER_EQUAL(tag, last);
    last = tag;
  }
  CHECK_EQUAL(last, 7.0f);
}

// Segments of the first edge of each face have at most sqrt(2) times the reference length. Returns
// the number of edges in front of the eye below the highest level.
int CheckSegments(
  RelevoCheck& check, vtkCamera* camera, vtkPolyData* mesh, const std::vector<float>& tags)
{
  int edges = 0;
  vtkNew<vtkIdList> ids;
  vtkMatrix4x4* toClip = camera->GetCompositeProjectionTransformMatrix(1.6, -1, 1);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double pixels[2][2];
    bool before = false;
    double tag = 0.0;
    for (int end = 0; end < 2; ++end)
    {
      double x[4] = { 0, 0, 0, 1 };
      mesh->GetPoint(ids->GetId(end), x);
      toClip->MultiplyPoint(x, x);
      before = before || x[3] < 0.02;
      pixels[end][0] = x[0] / x[3] * 320;
      pixels[end][1] = x[1] / x[3] * 200;
      tag += 0.5 * tags[ids->GetId(end)];
    }
    const double level = std::floor(tag + 0.5);
    if (!before && level < 7)
    {
      ++edges;
      const double length = std::hypot(pixels[0][0] - pixels[1][0], pixels[0][1] - pixels[1][1]);
      CHECK_LESS_EQUAL(length / std::exp2(level), 10.0 * std::sqrt(2.0) * 1.0001);
    }
  }
  return edges;
}

// With random cameras, segments have at most sqrt(2) times the reference length. More pixels and a
// shorter reference length never give lower levels.
void TestRandomCameras(RelevoCheck& check)
{
  Scene scene;
  std::mt19937 random(1);
  auto sphere = RelevoMeshes::Sphere(12, 9);
  int edges = 0;
  for (int i = 0; i < 200; ++i)
  {
    PlaceAtRandom(scene.Camera, random);
    scene.Metric->SetReferenceLength(20.0);
    const auto coarse = scene.GetTags(sphere, 7);
    scene.Metric->SetReferenceLength(10.0);
    const auto fine = scene.GetTags(sphere, 7);
    CHECK(AreLevels(fine, sphere->GetNumberOfPoints(), 7));
    for (std::size_t point = 0; point < fine.size(); ++point)
    {
      CHECK(fine[point] >= coarse[point] && fine[point] <= coarse[point] + 1.0001f);
    }
    scene.Camera->SetClippingRange(0.01, 1000.0);
    edges += CheckSegments(check, scene.Camera, sphere, fine);
  }
  CHECK_GREATER(edges, 10000);
  CHECK(SurvivesOddMeshes(scene.Metric));
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  RelevoErrors errors(scene.Metric);
  for (double bad : { 0.0, -1.0, 1e-9, 1e9, std::nan("") })
  {
    CHECK_CASE(bad);
    scene.Metric->SetReferenceLength(bad);
    CHECK(errors.Said("ReferenceLength") && scene.Metric->GetReferenceLength() == 10.0);
  }
  auto mesh = MakeTriangle();
  scene.View.ViewportSize[0] = 0;
  CHECK(scene.GetTags(mesh, 5).empty() && errors.Said("no pixels"));
  scene.View.ViewportSize[0] = 300;
  scene.Camera->SetPosition(1, 2, 3);
  scene.Camera->SetFocalPoint(1, 2, 3);
  CHECK(scene.GetTags(mesh, 5).empty() && errors.Said("no direction"));
  scene.Camera->SetFocalPoint(1, 2, 0);
  scene.Camera->SetViewUp(0, 0, 1);
  CHECK(scene.GetTags(mesh, 5).empty() && errors.Said("view-up"));
  scene.Camera->SetPosition(std::nan(""), 0, 0);
  CHECK(scene.GetTags(mesh, 5).empty() && errors.Said("not finite"));
  scene.View.Camera = nullptr;
  CHECK(scene.GetTags(mesh, 5).empty() && errors.Said("no camera"));
}
}

int TestScreenEdgeDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestLengths(check);
  TestMatrixAndViewport(check);
  TestSpheres(check);
  TestParallel(check);
  TestPerspective(check);
  TestFarFromOrigin(check);
  TestLogarithm(check);
  TestRandomCameras(check);
  TestErrors(check);
  return check.GetResult();
}

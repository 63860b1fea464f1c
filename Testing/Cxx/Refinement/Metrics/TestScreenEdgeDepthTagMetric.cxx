// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkScreenEdgeDepthTagMetric against projected lengths by hand.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkIdList.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkTransform.h"

#include <cmath>

int TestScreenEdgeDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  CHECK(metric->IsViewDependent() && metric->GetReferenceLength() == 10.0);

  // 90 degrees from 2 away: 4 units fill the 400 pixels of height, 100 pixels for a unit.
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 2);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(90);
  camera->SetClippingRange(0.1, 100.0);
  relevo::RefinementView view;
  view.Camera = camera;
  view.ViewportSize[0] = 640;
  view.ViewportSize[1] = 400;
  // The edges of point 0 are 0.8 and 0.6 long, that of 1 and 2 is 1.
  auto mesh = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0.8, 0, 0 } }, { { 0, 0.6, 0 } }, { { 9, 9, 9 } } },
    { { { 0, 1, 2 } } });
  auto tags = TagsOf(metric, mesh, view, 6);
  CHECK(tags.size() == 4);
  CHECK_NEAR(tags[0], 3.0, 1e-5);
  CHECK_NEAR(tags[1], std::log2(10.0), 1e-5);
  CHECK_NEAR(tags[2], std::log2(10.0), 1e-5);
  CHECK(tags[3] == 0.0f);
  metric->SetReferenceLength(20.0);
  CHECK_NEAR(TagsOf(metric, mesh, view, 6)[0], 2.0, 1e-5);
  CHECK(TagsOf(metric, mesh, view, 2)[1] == 2.0f);
  metric->SetReferenceLength(100.5);
  CHECK(TagsOf(metric, mesh, view, 6)[1] == 0.0f);
  metric->SetReferenceLength(10.0);

  // The actor's matrix counts, and so does the size of the window.
  vtkNew<vtkTransform> transform;
  transform->Scale(2, 2, 2);
  view.ModelToWorld = transform->GetMatrix();
  CHECK_NEAR(TagsOf(metric, mesh, view, 6)[0], 4.0, 1e-5);
  view.ModelToWorld = nullptr;
  view.ViewportSize[0] = 1280;
  view.ViewportSize[1] = 800;
  CHECK_NEAR(TagsOf(metric, mesh, view, 6)[0], 4.0, 1e-5);
  view.ViewportSize[0] = 200; // a narrow window has the scale of its height
  CHECK_NEAR(TagsOf(metric, mesh, view, 6)[0], 4.0, 1e-5);
  view.ViewportSize[0] = 640;
  view.ViewportSize[1] = 400;

  // Spheres do not depend on where an edge points: seen from the side as long as the edge, else
  // length over distance; also behind the eye. (The ones of points 0 and 1, 0 and 2 are beside the
  // middle of the view.)
  metric->SetMeasureToSphereDiameter();
  CHECK_NEAR(TagsOf(metric, mesh, view, 6)[0],
    std::log2(0.8 * 200.0 / std::sqrt(4.0 + 0.4 * 0.4) / 10.0), 1e-5);
  auto endOn = RelevoMeshes::FromTriangles({ { { 0, 0, 1 } }, { { 0, 0, -1 } }, { { 0, 1e-3, -1 } },
                                             { { 0, 0, 3 } }, { { 0, 0, 5 } }, { { 0, 1e-3, 5 } } },
    { { { 0, 1, 2 } }, { { 3, 4, 5 } } });
  tags = TagsOf(metric, endOn, view, 6);
  CHECK_NEAR(tags[0], std::log2(2.0 * 200.0 / 2.0 / 10.0), 1e-3);
  CHECK_NEAR(tags[3], std::log2(2.0 * 200.0 / 2.0 / 10.0), 1e-3);
  camera->SetPosition(0, 0, 0.9); // inside the sphere of the edge
  CHECK_NEAR(TagsOf(metric, endOn, view, 7)[0], std::log2(2.0 * 200.0 / 1.0 / 10.0), 1e-3);
  camera->SetPosition(0, 0, 2);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.0);
  CHECK_NEAR(TagsOf(metric, endOn, view, 6)[0], std::log2(2.0 * 100.0 / 10.0), 1e-3);
  camera->ParallelProjectionOff();
  metric->SetMeasureToProjectedLength();
  CHECK(TagsOf(metric, endOn, view, 6)[3] == 0.0f);
  RelevoErrors measureErrors(metric);
  metric->SetMeasure(2);
  CHECK(measureErrors.Said("must be one of PROJECTED_LENGTH (0), SPHERE_DIAMETER (1)"));

  // Parallel: a height of 2 * 2 units in 400 pixels, also behind the eye.
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.0);
  CHECK_NEAR(TagsOf(metric, mesh, view, 6)[0], 3.0, 1e-5);
  auto behind = RelevoMeshes::FromTriangles(
    { { { 0, 0, 5 } }, { { 0.8, 0, 5 } }, { { 0, 0.6, 5 } } }, { { { 0, 1, 2 } } });
  CHECK_NEAR(TagsOf(metric, behind, view, 6)[0], 3.0, 1e-5);

  // Perspective: nothing behind the eye, and edges cut at the near plane. Of the edge from 1 below
  // the axis at the eye's depth to 1 below at depth 4, the part beyond depth 1 projects from 1 to
  // 1/4 of half the height: 150 pixels.
  camera->ParallelProjectionOff();
  CHECK(TagsOf(metric, behind, view, 6)[0] == 0.0f);
  camera->SetClippingRange(1.0, 100.0);
  auto across = RelevoMeshes::FromTriangles(
    { { { 0, -1, 2 } }, { { 0, -1, -2 } }, { { 0, -1.001, 2 } } }, { { { 0, 1, 2 } } });
  metric->SetReferenceLength(0.01);
  tags = TagsOf(metric, across, view, 20);
  CHECK_NEAR(std::exp2(tags[0]), 15000.0, 10.0);
  metric->SetReferenceLength(1.0);
  // Through the eye itself, along the axis: a point on the screen.
  auto axis = RelevoMeshes::FromTriangles(
    { { { 0, 0, 4 } }, { { 0, 0, 0 } }, { { 0, 1e-9, 4 } } }, { { { 0, 1, 2 } } });
  CHECK(AreLevels(TagsOf(metric, axis, view, 5), 3, 5));
  CHECK(TagsOf(metric, axis, view, 5)[1] < 0.1f);

  // Far from the origin.
  metric->SetReferenceLength(10.0);
  camera->SetClippingRange(0.1, 100.0);
  camera->SetPosition(5e6, 4e6, 2);
  camera->SetFocalPoint(5e6, 4e6, 0);
  auto corner = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0.75, 0, 0 } }, { { 0, 0.5, 0 } } }, { { { 0, 1, 2 } } });
  const double offset[3] = { 5e6, 4e6, 0 };
  auto far = RelevoMeshes::Moved(corner, 1.0, offset, VTK_DOUBLE);
  CHECK_NEAR(TagsOf(metric, far, view, 6)[0], std::log2(7.5), 1e-4);

  // The logarithm, for all lengths up to 2^7 segments, one pixel for a unit.
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
    CHECK(tag >= last);
    last = tag;
  }
  CHECK(last == 7.0f);
  metric->SetReferenceLength(10.0);

  // Properties over random cameras: segments of at most sqrt(2) of the reference, more pixels and a
  // shorter reference never give less.
  std::mt19937 random(1);
  auto sphere = RelevoMeshes::Sphere(12, 9);
  vtkNew<vtkIdList> ids;
  int edges = 0;
  for (int i = 0; i < 200; ++i)
  {
    PlaceAtRandom(camera, random);
    metric->SetReferenceLength(20.0);
    const auto coarse = TagsOf(metric, sphere, view, 7);
    metric->SetReferenceLength(10.0);
    const auto fine = TagsOf(metric, sphere, view, 7);
    CHECK(AreLevels(fine, sphere->GetNumberOfPoints(), 7));
    for (std::size_t point = 0; point < fine.size(); ++point)
    {
      CHECK(fine[point] >= coarse[point] && fine[point] <= coarse[point] + 1.0001f);
    }
    camera->SetClippingRange(0.01, 1000.0);
    vtkMatrix4x4* toClip = camera->GetCompositeProjectionTransformMatrix(1.6, -1, 1);
    for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
    {
      sphere->GetCellPoints(cell, ids);
      double pixels[2][2];
      bool before = false;
      double tag = 0.0;
      for (int end = 0; end < 2; ++end)
      {
        double x[4] = { 0, 0, 0, 1 };
        sphere->GetPoint(ids->GetId(end), x);
        toClip->MultiplyPoint(x, x);
        before = before || x[3] < 0.02;
        pixels[end][0] = x[0] / x[3] * 320;
        pixels[end][1] = x[1] / x[3] * 200;
        tag += 0.5 * fine[ids->GetId(end)];
      }
      const double level = std::floor(tag + 0.5);
      if (!before && level < 7)
      {
        ++edges;
        const double length = std::hypot(pixels[0][0] - pixels[1][0], pixels[0][1] - pixels[1][1]);
        CHECK(length / std::exp2(level) <= 10.0 * std::sqrt(2.0) * 1.0001);
      }
    }
  }
  CHECK(edges > 10000);
  CHECK(SurvivesOddMeshes(metric));

  // Errors.
  RelevoErrors errors(metric);
  for (double bad : { 0.0, -1.0, 1e-9, 1e9, std::nan("") })
  {
    metric->SetReferenceLength(bad);
    CHECK(errors.Said("ReferenceLength") && metric->GetReferenceLength() == 10.0);
  }
  view.ViewportSize[0] = 0;
  CHECK(TagsOf(metric, mesh, view, 5).empty() && errors.Said("no pixels"));
  view.ViewportSize[0] = 300;
  camera->SetPosition(1, 2, 3);
  camera->SetFocalPoint(1, 2, 3);
  CHECK(TagsOf(metric, mesh, view, 5).empty() && errors.Said("no direction"));
  camera->SetFocalPoint(1, 2, 0);
  camera->SetViewUp(0, 0, 1);
  CHECK(TagsOf(metric, mesh, view, 5).empty() && errors.Said("view-up"));
  camera->SetPosition(std::nan(""), 0, 0);
  CHECK(TagsOf(metric, mesh, view, 5).empty() && errors.Said("not finite"));
  view.Camera = nullptr;
  CHECK(TagsOf(metric, mesh, view, 5).empty() && errors.Said("no camera"));
  return check.GetResult();
}

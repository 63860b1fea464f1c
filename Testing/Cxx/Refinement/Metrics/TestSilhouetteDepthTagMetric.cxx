// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSilhouetteDepthTagMetric against levels by hand, on open and closed surfaces.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkTransform.h"

#include <cmath>

int TestSilhouetteDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkSilhouetteDepthTagMetric> metric;
  CHECK(metric->IsViewDependent());
  CHECK(metric->GetCriterion() == vtkSilhouetteDepthTagMetric::NORMAL_ANGLE);
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(0, 0, 0);
  relevo::RefinementView view;
  view.Camera = camera;

  // By the angle. A triangle with the normal +z, seen from its first corner's direction (0, s, c).
  auto triangle = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
  for (bool parallel : { false, true })
  {
    camera->SetParallelProjection(parallel);
    for (double degrees : { 0.0, 30.0, 60.0, 90.0, 150.0, 180.0 })
    {
      const double angle = vtkMath::RadiansFromDegrees(degrees);
      camera->SetPosition(0, 5 * std::sin(angle), 5 * std::cos(angle));
      const auto tags = TagsOf(metric, triangle, view, 4);
      CHECK_NEAR(tags[0], 4.0 * (1.0 - std::abs(std::cos(angle))), 1e-5);
      if (parallel)
      {
        CHECK_NEAR(tags[2], tags[0], 1e-6);
      }
    }
  }
  camera->ParallelProjectionOff();

  // The mesh's own normals win; zero and NaN ones do not count.
  camera->SetPosition(0, 0, 5);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0, 3, 4);
  normals->InsertNextTuple3(0, 0, 0);
  normals->InsertNextTuple3(std::nanf(""), 0, 1);
  triangle->GetPointData()->SetNormals(normals);
  auto tags = TagsOf(metric, triangle, view, 5);
  CHECK_NEAR(tags[0], 5.0 * (1.0 - 0.8), 1e-5);
  CHECK_NEAR(tags[1], 5.0 * (1.0 - 5.0 / std::sqrt(26.0)), 1e-5);
  CHECK_NEAR(tags[2], tags[1], 1e-5);
  // Normals under a matrix that stretches: (0, 3, 4) becomes (0, 3, 4 / 2).
  vtkNew<vtkTransform> transform;
  transform->Scale(1, 1, 2);
  view.ModelToWorld = transform->GetMatrix();
  CHECK_NEAR(TagsOf(metric, triangle, view, 5)[0], 5.0 * (1.0 - 2.0 / std::sqrt(13.0)), 1e-5);
  view.ModelToWorld = nullptr;

  // The eye on a vertex.
  camera->SetFocalPoint(0, 0, -1);
  camera->SetPosition(0, 0, 0);
  CHECK(TagsOf(metric, triangle, view, 5)[0] == 5.0f);
  CHECK(SurvivesOddMeshes(metric));

  // On a fine sphere seen from the distance D the contour is where the radius has the cosine 1 / D,
  // and nowhere else is the level higher.
  auto sphere = RelevoMeshes::Sphere(64, 63);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, 0, 1.5); // of a radius of 1/2: D = 3
  tags = TagsOf(metric, sphere, view, 5);
  for (vtkIdType point = 0; point < sphere->GetNumberOfPoints(); ++point)
  {
    double x[3];
    sphere->GetPoint(point, x);
    const double toEye[3] = { -x[0], -x[1], 1.5 - x[2] };
    const double cosine = vtkMath::Dot(x, toEye) / (vtkMath::Norm(x) * vtkMath::Norm(toEye));
    CHECK_NEAR(tags[point], 5.0 * (1.0 - std::abs(cosine)), 1e-4);
  }

  // By the contour. A triangle is nothing but border.
  metric->SetCriterionToContour();
  CHECK(std::string(metric->GetCriterionAsString()) == "Contour");
  camera->ParallelProjectionOn();
  camera->SetPosition(0, 0, 5);
  CHECK(TagsOf(metric, triangle, view, 5) == std::vector<float>(3, 5.0f));

  // A tube of many sides, seen across: contour where a strip faces away, fading to 0 with the
  // cosine over the width.
  const int sides = 64;
  std::vector<std::array<double, 3>> points;
  std::vector<RelevoMeshes::Triangle> triangles;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / sides;
    for (double y : { -3.0, 0.0, 3.0 })
    {
      points.push_back({ { std::cos(angle), y, std::sin(angle) } });
    }
    const vtkIdType here = 3 * i;
    const vtkIdType there = 3 * ((i + 1) % sides);
    for (vtkIdType row : { 0, 1 })
    {
      triangles.push_back({ { here + row, here + row + 1, there + row } });
      triangles.push_back({ { there + row, here + row + 1, there + row + 1 } });
    }
  }
  auto tube = RelevoMeshes::FromTriangles(points, triangles);
  metric->SetContourWidth(0.3);
  camera->SetPosition(0, 0, 5);
  tags = TagsOf(metric, tube, view, 5);
  int contours = 0;
  int faded = 0;
  for (int i = 0; i < sides; ++i)
  {
    // The strips on the two sides have their normals half a step away.
    const double before = std::sin(2.0 * vtkMath::Pi() * (i - 0.5) / sides);
    const double after = std::sin(2.0 * vtkMath::Pi() * (i + 0.5) / sides);
    const double f = before * after <= 0.0 ? 0.0 : std::min(std::abs(before), std::abs(after));
    // The diagonals lie in strips of one cosine, the edges across between two equal ones.
    CHECK_NEAR(tags[3 * i + 1], 5.0 * std::max(0.0, 1.0 - f / 0.3), 1e-3);
    CHECK(tags[3 * i] == 5.0f); // the border
    contours += tags[3 * i + 1] == 5.0f;
    faded += tags[3 * i + 1] > 0.0f && tags[3 * i + 1] < 5.0f;
  }
  CHECK(contours == 2 && faded > 4);
  // Seams are no borders, and neither are triangles that wind against each other.
  tags = TagsOf(metric, tube, view, 5);
  const auto exploded = RelevoMeshes::Explode(tube);
  const auto ofExploded = TagsOf(metric, exploded, view, 5);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      CHECK_NEAR(ofExploded[3 * i + corner], tags[triangles[i][corner]], 1e-5);
    }
    if (i % 3 == 0)
    {
      std::swap(triangles[i][0], triangles[i][1]);
    }
  }
  const auto flipped = TagsOf(metric, RelevoMeshes::FromTriangles(points, triangles), view, 5);
  for (std::size_t i = 0; i < tags.size(); ++i)
  {
    CHECK_NEAR(flipped[i], tags[i], 1e-5);
  }
  CHECK(SurvivesOddMeshes(metric));

  // A wider contour never gives less, over random cameras.
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i)
  {
    PlaceAtRandom(camera, random);
    metric->SetContourWidth(0.1);
    const auto narrow = TagsOf(metric, sphere, view, 5);
    metric->SetContourWidth(0.4);
    const auto wide = TagsOf(metric, sphere, view, 5);
    for (std::size_t point = 0; point < wide.size(); ++point)
    {
      CHECK(wide[point] >= narrow[point]);
    }
  }

  // Errors.
  RelevoErrors errors(metric);
  for (double bad : { 0.0, -1.0, 1.5, std::nan("") })
  {
    metric->SetContourWidth(bad);
    CHECK(errors.Said("ContourWidth") && metric->GetContourWidth() == 0.4);
  }
  metric->SetCriterion(2);
  CHECK(errors.Said("Criterion") && metric->GetCriterion() == vtkSilhouetteDepthTagMetric::CONTOUR);
  camera->SetPosition(1, 2, 3);
  camera->SetFocalPoint(1, 2, 3);
  CHECK(TagsOf(metric, triangle, view, 5).empty() && errors.Said("no direction"));
  view.Camera = nullptr;
  CHECK(TagsOf(metric, triangle, view, 5).empty() && errors.Said("no camera"));
  return check.GetResult();
}

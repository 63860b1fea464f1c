// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSilhouetteDepthTagMetric promises levels by normals or by the contour, compared with values
// computed by hand on open and closed surfaces.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
// A metric and a camera that looks at the origin.
struct Scene
{
  Scene()
  {
    this->Camera->SetFocalPoint(0, 0, 0);
    this->Camera->SetPosition(0, 0, 5);
    this->View.Camera = this->Camera;
  }
  std::vector<float> GetTags(vtkPolyData* mesh, int maximumLevel)
  {
    return TagsOf(this->Metric, mesh, this->View, maximumLevel);
  }

  vtkNew<vtkSilhouetteDepthTagMetric> Metric;
  vtkNew<vtkCamera> Camera;
  relevo::RefinementView View;
};

// A triangle with normal +z.
RelevoMeshes::Mesh MakeTriangle()
{
  return RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
}

// A triangle with point normals. Zero and NaN normals are ignored.
RelevoMeshes::Mesh MakeTriangleWithNormals()
{
  auto triangle = MakeTriangle();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0, 3, 4);
  normals->InsertNextTuple3(0, 0, 0);
  normals->InsertNextTuple3(std::nanf(""), 0, 1);
  triangle->GetPointData()->SetNormals(normals);
  return triangle;
}

// A triangle seen from the direction (0, s, c) of its first corner.
void TestNormalAngle(RelevoCheck& check)
{
  Scene scene;
  CHECK(scene.Metric->IsViewDependent());
  CHECK_EQUAL(scene.Metric->GetCriterion(), vtkSilhouetteDepthTagMetric::NORMAL_ANGLE);
  auto triangle = MakeTriangle();
  for (bool parallel : { false, true })
  {
    CHECK_CASE(parallel);
    scene.Camera->SetParallelProjection(parallel);
    for (double degrees : { 0.0, 30.0, 60.0, 90.0, 150.0, 180.0 })
    {
      CHECK_CASE(degrees);
      const double angle = vtkMath::RadiansFromDegrees(degrees);
      scene.Camera->SetPosition(0, 5 * std::sin(angle), 5 * std::cos(angle));
      const auto tags = scene.GetTags(triangle, 4);
      CHECK_NEAR(tags[0], 4.0 * (1.0 - std::abs(std::cos(angle))), 1e-5);
      if (parallel)
      {
        CHECK_NEAR(tags[2], tags[0], 1e-6);
      }
    }
  }
}

// The mesh's normals have precedence.
void TestOwnNormals(RelevoCheck& check)
{
  Scene scene;
  auto triangle = MakeTriangleWithNormals();
  const auto tags = scene.GetTags(triangle, 5);
  CHECK_NEAR(tags[0], 5.0 * (1.0 - 0.8), 1e-5);
  CHECK_NEAR(tags[1], 5.0 * (1.0 - 5.0 / std::sqrt(26.0)), 1e-5);
  CHECK_NEAR(tags[2], tags[1], 1e-5);
  // Normals under a matrix that stretches: (0, 3, 4) becomes (0, 3, 4 / 2).
  vtkNew<vtkTransform> transform;
  transform->Scale(1, 1, 2);
  scene.View.ModelToWorld = transform->GetMatrix();
  CHECK_NEAR(scene.GetTags(triangle, 5)[0], 5.0 * (1.0 - 2.0 / std::sqrt(13.0)), 1e-5);
  scene.View.ModelToWorld = nullptr;

  // The eye is at a vertex.
  scene.Camera->SetFocalPoint(0, 0, -1);
  scene.Camera->SetPosition(0, 0, 0);
  CHECK_EQUAL(scene.GetTags(triangle, 5)[0], 5.0f);
  CHECK(SurvivesOddMeshes(scene.Metric));
}

// On a fine sphere seen from distance D, the contour is where the radius has the cosine 1 / D.
// Levels are highest there.
void TestFineSphere(RelevoCheck& check)
{
  Scene scene;
  auto sphere = RelevoMeshes::Sphere(64, 63);
  scene.Camera->SetPosition(0, 0, 1.5); // the radius is 1/2, so D = 3
  const auto tags = scene.GetTags(sphere, 5);
  for (vtkIdType point = 0; point < sphere->GetNumberOfPoints(); ++point)
  {
    double x[3];
    sphere->GetPoint(point, x);
    const double toEye[3] = { -x[0], -x[1], 1.5 - x[2] };
    const double cosine = vtkMath::Dot(x, toEye) / (vtkMath::Norm(x) * vtkMath::Norm(toEye));
    CHECK_NEAR(tags[point], 5.0 * (1.0 - std::abs(cosine)), 1e-4);
  }
}

// All edges of a single triangle are border edges.
void TestBorder(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetCriterionToContour();
  CHECK_EQUAL(std::string(scene.Metric->GetCriterionAsString()), "Contour");
  scene.Camera->ParallelProjectionOn();
  CHECK_EQUAL(scene.GetTags(MakeTriangleWithNormals(), 5), std::vector<float>(3, 5.0f));
}

// A tube with many sides around the y axis, and its contour seen from the side.
struct TubeScene : Scene
{
  TubeScene()
  {
    for (int i = 0; i < Sides; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / Sides;
      for (double y : { -3.0, 0.0, 3.0 })
      {
        this->Points.push_back({ { std::cos(angle), y, std::sin(angle) } });
      }
      const vtkIdType here = 3 * i;
      const vtkIdType there = 3 * ((i + 1) % Sides);
      for (vtkIdType row : { 0, 1 })
      {
        this->Triangles.push_back({ { here + row, here + row + 1, there + row } });
        this->Triangles.push_back({ { there + row, here + row + 1, there + row + 1 } });
      }
    }
    this->Metric->SetCriterionToContour();
    this->Metric->SetContourWidth(0.3);
    this->Camera->ParallelProjectionOn();
  }

  static constexpr int Sides = 64;
  std::vector<std::array<double, 3>> Points;
  std::vector<RelevoMeshes::Triangle> Triangles;
};

// The contour is where a strip faces away. Levels fade to 0 with the cosine over the width.
void TestTube(RelevoCheck& check)
{
  TubeScene scene;
  constexpr int sides = TubeScene::Sides;
  const auto tags = scene.GetTags(RelevoMeshes::FromTriangles(scene.Points, scene.Triangles), 5);
  int contours = 0;
  int faded = 0;
  for (int i = 0; i < sides; ++i)
  {
    // The normals of the strips on the two sides are half a step away.
    const double before = std::sin(2.0 * vtkMath::Pi() * (i - 0.5) / sides);
    const double after = std::sin(2.0 * vtkMath::Pi() * (i + 0.5) / sides);
    const double f = before * after <= 0.0 ? 0.0 : std::min(std::abs(before), std::abs(after));
    // Diagonals lie within strips of one cosine, the edges across between two equal strips.
    CHECK_NEAR(tags[3 * i + 1], 5.0 * std::max(0.0, 1.0 - f / 0.3), 1e-3);
    CHECK_EQUAL(tags[3 * i], 5.0f); // on the border
    contours += tags[3 * i + 1] == 5.0f;
    faded += tags[3 * i + 1] > 0.0f && tags[3 * i + 1] < 5.0f;
  }
  CHECK_EQUAL(contours, 2);
  CHECK_GREATER(faded, 4);
}

// Seams and edges between triangles of opposite winding are not borders.
void TestSeams(RelevoCheck& check)
{
  TubeScene scene;
  auto& triangles = scene.Triangles;
  auto tube = RelevoMeshes::FromTriangles(scene.Points, triangles);
  const auto tags = scene.GetTags(tube, 5);
  const auto ofExploded = scene.GetTags(RelevoMeshes::Explode(tube), 5);
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
  const auto flipped = scene.GetTags(RelevoMeshes::FromTriangles(scene.Points, triangles), 5);
  for (std::size_t i = 0; i < tags.size(); ++i)
  {
    CHECK_NEAR(flipped[i], tags[i], 1e-5);
  }
  CHECK(SurvivesOddMeshes(scene.Metric));
}

// With random cameras, a wider contour never gives lower levels.
void TestWidths(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetCriterionToContour();
  auto sphere = RelevoMeshes::Sphere(64, 63);
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i)
  {
    PlaceAtRandom(scene.Camera, random);
    scene.Metric->SetContourWidth(0.1);
    const auto narrow = scene.GetTags(sphere, 5);
    scene.Metric->SetContourWidth(0.4);
    const auto wide = scene.GetTags(sphere, 5);
    for (std::size_t point = 0; point < wide.size(); ++point)
    {
      CHECK_GREATER_EQUAL(wide[point], narrow[point]);
    }
  }
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  vtkSilhouetteDepthTagMetric* metric = scene.Metric;
  metric->SetCriterionToContour();
  metric->SetContourWidth(0.4);
  RelevoErrors errors(metric);
  for (double bad : { 0.0, -1.0, 1.5, std::nan("") })
  {
    CHECK_CASE(bad);
    metric->SetContourWidth(bad);
    CHECK(errors.Said("ContourWidth") && metric->GetContourWidth() == 0.4);
  }
  metric->SetCriterion(2);
  CHECK(errors.Said("Criterion") && metric->GetCriterion() == vtkSilhouetteDepthTagMetric::CONTOUR);
  auto triangle = MakeTriangleWithNormals();
  scene.Camera->SetPosition(1, 2, 3);
  scene.Camera->SetFocalPoint(1, 2, 3);
  CHECK(scene.GetTags(triangle, 5).empty() && errors.Said("no direction"));
  scene.View.Camera = nullptr;
  CHECK(scene.GetTags(triangle, 5).empty() && errors.Said("no camera"));
}
}

int TestSilhouetteDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestNormalAngle(check);
  TestOwnNormals(check);
  TestFineSphere(check);
  TestBorder(check);
  TestTube(check);
  TestSeams(check);
  TestWidths(check);
  TestErrors(check);
  return check.GetResult();
}

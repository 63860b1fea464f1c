// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkProximityDepthTagMetric promises levels by the distance from boxes, compared with values
// computed by hand and with a search through all boxes.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkLookupTable.h"
#include "vtkProximityDepthTagMetric.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>
#include <string>

namespace
{
using Bounds = std::array<double, 6>;

const double NaN = std::nan("");
constexpr double Infinity = std::numeric_limits<double>::infinity();
const Bounds UnitBox{ { 0, 1, 0, 1, 0, 1 } };

// A triangle with its centroid at x.
RelevoMeshes::Mesh MakeTriangle(double x)
{
  return RelevoMeshes::FromTriangles(
    { { { x - 0.01, 0, 0 } }, { { x + 0.01, 0.01, 0 } }, { { x, -0.01, 0 } } },
    { { { 0, 1, 2 } } });
}

float LevelAt(vtkDepthTagMetric* metric, double x, int maximumLevel = 5)
{
  const auto tags = TagsOf(metric, MakeTriangle(x), {}, maximumLevel);
  return tags.size() == 3 && tags[0] == tags[1] && tags[1] == tags[2] ? tags[0] : -1.0f;
}

void TestByHand(RelevoCheck& check)
{
  vtkNew<vtkProximityDepthTagMetric> metric;
  CHECK(!metric->IsViewDependent() && metric->IsPlacementDependent() && metric->IsAbsolute());
  CHECK(metric->GetDistance() == 0.0 && LevelAt(metric, 0.5) == 0.0f);
  metric->AddBox(UnitBox.data());
  CHECK(LevelAt(metric, 0.5) == 5.0f && LevelAt(metric, 1.1) == 0.0f);
  metric->SetDistance(2.0);
  CHECK_NEAR(LevelAt(metric, 1.0 + 1e-5), std::log2(24.0), 1e-3);
  CHECK_NEAR(LevelAt(metric, 2.0), std::log2(12.5), 1e-5);
  CHECK_NEAR(LevelAt(metric, -1.5), std::log2(24.0 - 23.0 * 0.75), 1e-5);
  CHECK_NEAR(LevelAt(metric, 2.999), std::log2(24.0 - 23.0 * 0.9995), 1e-4);
  CHECK_EQUAL(LevelAt(metric, 3.01), 0.0f);
  // The recipe's MaximumLevel limits them.
  CHECK(LevelAt(metric, 0.5, 3) == 3.0f && LevelAt(metric, 2.0, 3) == 3.0f);
  CHECK_EQUAL(LevelAt(metric, 0.5, 7), 5.0f);
  // The nearer of two boxes decides. One of them is flat.
  const Bounds flat{ { 2.5, 2.5, -1, 1, -1, 1 } };
  metric->AddBox(flat.data());
  CHECK_EQUAL(metric->GetNumberOfBoxes(), 2);
  CHECK_NEAR(LevelAt(metric, 2.0), std::log2(24.0 - 23.0 * 0.25), 1e-5);
  CHECK_NEAR(LevelAt(metric, 1.5), std::log2(24.0 - 23.0 * 0.25), 1e-5);
  Bounds box{};
  metric->GetBox(1, box.data());
  CHECK_EQUAL(box, flat);
  metric->RemoveAllBoxes();
  CHECK(metric->GetNumberOfBoxes() == 0 && LevelAt(metric, 0.5) == 0.0f);
}

double ExpectedLevel(const double x[3], const std::vector<Bounds>& boxes, double distance)
{
  double nearest = Infinity;
  for (const Bounds& box : boxes)
  {
    double square = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double gap = std::max({ box[2 * c] - x[c], x[c] - box[2 * c + 1], 0.0 });
      square += gap * gap;
    }
    nearest = std::min(nearest, std::sqrt(square));
  }
  return nearest == 0.0 ? 5.0
                        : (nearest > distance ? 0.0 : std::log2(24.0 - 23.0 * nearest / distance));
}

// Points and edges have the largest level of their triangles, for every actor matrix.
void TestManyBoxes(RelevoCheck& check)
{
  std::mt19937 random(5);
  auto sphere = RelevoMeshes::Explode(RelevoMeshes::Sphere(25, 23));
  const relevo::SurfaceEdges edges(sphere);
  vtkNew<vtkProximityDepthTagMetric> metric;
  KeptMetric kept(metric);
  std::vector<Bounds> boxes;
  int numberInside = 0;
  for (int round = 0; round < 4; ++round)
  {
    for (int i = 0; i < 50; ++i)
    {
      Bounds box;
      for (int c = 0; c < 3; ++c)
      {
        box[2 * c] = 1.5 * Random(random);
        box[2 * c + 1] = box[2 * c] + 0.2 + 0.1 * Random(random);
      }
      boxes.push_back(box);
      metric->AddBox(box.data());
    }
    const double distance = 0.1 + 0.05 * round;
    metric->SetDistance(distance);
    vtkNew<vtkTransform> transform;
    transform->Translate(Random(random), Random(random), Random(random));
    transform->RotateWXYZ(50.0 * round, 1, 2, 3);
    transform->Scale(1.5, 0.8, 1.1);
    relevo::RefinementView view;
    view.ModelToWorld = transform->GetMatrix();
    std::vector<double> ofMergedPoints(sphere->GetNumberOfPoints(), 0.0);
    std::vector<double> ofEdges(edges.GetNumberOfEdges(), 0.0);
    for (const auto& triangle : edges.GetTriangles().GetTriangles())
    {
      double centroid[3] = { 0, 0, 0 };
      for (vtkIdType corner : triangle)
      {
        for (int c = 0; c < 3; ++c)
        {
          centroid[c] += sphere->GetPoint(corner)[c] / 3.0;
        }
      }
      transform->TransformPoint(centroid, centroid);
      const double level = ExpectedLevel(centroid, boxes, distance);
      numberInside += level == 5.0;
      for (int corner = 0; corner < 3; ++corner)
      {
        double& ofPlace = ofMergedPoints[triangle[corner]];
        ofPlace = std::max(ofPlace, level);
        double& ofEdge = ofEdges[edges.FindEdge(triangle[corner], triangle[(corner + 1) % 3])];
        ofEdge = std::max(ofEdge, level);
      }
    }
    const auto tags = kept.GetTags(sphere, view, 5);
    const auto edgeTags = kept.GetEdgeTags(sphere, view, 5);
    CHECK_EQUAL(tags.size(), ofMergedPoints.size());
    CHECK_EQUAL(edgeTags.size(), ofEdges.size());
    for (std::size_t i = 0; i < tags.size(); ++i)
    {
      CHECK_NEAR(tags[i],
        ofMergedPoints[edges.GetTriangles().GetMergedPoint(static_cast<vtkIdType>(i))], 1e-4);
    }
    for (std::size_t i = 0; i < edgeTags.size(); ++i)
    {
      CHECK_NEAR(edgeTags[i], ofEdges[i], 1e-4);
    }
  }
  CHECK_GREATER(numberInside, 10);
}

void TestColors(RelevoCheck& check)
{
  vtkNew<vtkProximityDepthTagMetric> metric;
  vtkLookupTable* table = metric->GetLookupTable();
  CHECK_EQUAL(table, metric->GetLookupTable());
  double color[3];
  for (double level : { 5.0, 4.7 })
  {
    CHECK_CASE(level);
    table->GetColor(level, color);
    CHECK(color[0] > 0.7 && color[1] < 0.2 && color[2] < 0.2);
  }
  table->GetColor(0.0, color);
  CHECK(color[0] < 0.3 && color[2] > 0.7);
  double before = 0.0;
  for (double level : { 4.55, 3.0, 2.0, 1.0, 0.1 })
  {
    CHECK_CASE(level);
    table->GetColor(level, color);
    CHECK(color[0] > 0.95 && color[1] > before && color[2] < color[1]);
    before = color[1];
  }
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkProximityDepthTagMetric> metric;
  RelevoErrors errors(metric);
  for (int i = 0; i < 6; ++i)
  {
    for (double bad : { NaN, Infinity, -Infinity, i % 2 == 0 ? 2.0 : -1.0 })
    {
      CHECK_CASE(bad);
      Bounds box = UnitBox;
      box[i] = bad;
      metric->AddBox(box.data());
      CHECK(errors.Said("A box must be finite, with minima not above their maxima, got ("));
    }
  }
  CHECK_EQUAL(metric->GetNumberOfBoxes(), 0);
  for (double bad : { -1.0, NaN, Infinity })
  {
    CHECK_CASE(bad);
    metric->SetDistance(bad);
    CHECK(errors.Said("Distance must be at least 0 and finite") && metric->GetDistance() == 0.0);
  }
  metric->AddBox(UnitBox.data());
  Bounds box = UnitBox;
  for (int index : { -1, 1 })
  {
    CHECK_CASE(index);
    metric->GetBox(index, box.data());
    CHECK(errors.Said("There is no box " + std::to_string(index) + ": the number of boxes is 1."));
  }
  CHECK_EQUAL(box, UnitBox);
  metric->SetDistance(0.5);
  CHECK(SurvivesOddMeshes(metric));
  auto mesh = RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { NaN, 0, 0 } } },
    { { { 0, 1, 2 } }, { { 1, 2, 3 } } });
  const auto tags = TagsOf(metric, mesh, {}, 5);
  CHECK_EQUAL(tags, std::vector<float>({ 5.0f, 5.0f, 5.0f, 0.0f }));
}
}

int TestProximityDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestByHand(check);
  TestManyBoxes(check);
  TestColors(check);
  TestErrors(check);
  return check.GetResult();
}

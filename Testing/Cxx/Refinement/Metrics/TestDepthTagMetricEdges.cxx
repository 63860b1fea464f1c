// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthTagMetric promises for PER_EDGE: the tag of an edge depends on that edge alone. Tags are
// compared with values computed by hand.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkCellArray.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkIdList.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <algorithm>
#include <cmath>

namespace
{
// Levels of edges (a, b), computed by hand.
class Edges
{
public:
  explicit Edges(vtkPolyData* mesh)
    : Mesh(mesh)
    , Surface(mesh)
  {
  }
  float GetTag(vtkDepthTagMetric* metric, const relevo::RefinementView& view, int maximumLevel,
    int a, int b) const
  {
    const auto tags = EdgeTagsOf(metric, this->Mesh, view, maximumLevel, this->Surface);
    return tags.empty() ? -1.0f : tags[this->Surface.FindEdge(a, b)];
  }

  RelevoMeshes::Mesh Mesh;
  relevo::SurfaceEdges Surface;
};

// The edges of point 0 have lengths 0.8 and 0.6; that between 1 and 2 has length 1.
Edges MakeTriangle()
{
  return Edges(RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 0.8, 0, 0 } }, { { 0, 0.6, 0 } } }, { { { 0, 1, 2 } } }));
}

// Two triangles that meet at a right angle.
Edges MakeRoof()
{
  return Edges(RelevoMeshes::FromTriangles(
    { { { 0, -1, 0 } }, { { 0, 1, 0 } }, { { 1, 0, -1 } }, { { -1, 0, -1 } } },
    { { { 0, 2, 1 } }, { { 0, 1, 3 } } }));
}

void AddValues(vtkPolyData* triangle)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (float value : { 0.0f, 4.0f, 1.0f })
  {
    values->InsertNextValue(value);
  }
  triangle->GetPointData()->AddArray(values);
}

// One unit covers 100 pixels. The level follows from each edge's length.
void TestScreenEdge(RelevoCheck& check)
{
  const FrontView front;
  const Edges triangle = MakeTriangle();
  vtkNew<vtkScreenEdgeDepthTagMetric> screenEdge;
  CHECK_NEAR(triangle.GetTag(screenEdge, front.View, 6, 0, 1), 3.0, 1e-5);
  CHECK_NEAR(triangle.GetTag(screenEdge, front.View, 6, 0, 2), std::log2(6.0), 1e-5);
  CHECK_NEAR(triangle.GetTag(screenEdge, front.View, 6, 1, 2), std::log2(10.0), 1e-5);
}

// The nearer end decides.
void TestDistance(RelevoCheck& check)
{
  const FrontView front;
  const Edges triangle = MakeTriangle();
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMaximumDistance(4.0);
  CHECK_NEAR(triangle.GetTag(distance, front.View, 6, 0, 1), 3.0, 1e-5);
  CHECK_NEAR(
    triangle.GetTag(distance, front.View, 6, 1, 2), 6.0 * (1.0 - std::sqrt(4.36) / 4.0), 1e-5);
}

// A ball that touches the middle of an edge and neither end, and a half space.
void TestRegion(RelevoCheck& check)
{
  const FrontView front;
  const Edges triangle = MakeTriangle();
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetCenter(0.4, -0.2, 0);
  region->SetRadius(0.15);
  region->SetFallOff(0.1);
  // The ball is at half of the fall-off distance.
  CHECK_NEAR(triangle.GetTag(region, front.View, 6, 0, 1), 3.0, 1e-5);
  CHECK_EQUAL(triangle.GetTag(region, front.View, 6, 0, 2), 0.0f);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.7, 0, 0);
  plane->SetNormal(-1, 0, 0);
  region->SetImplicitFunction(plane);
  CHECK_EQUAL(triangle.GetTag(region, front.View, 6, 0, 1), 6.0f);
  CHECK_EQUAL(triangle.GetTag(region, front.View, 6, 0, 2), 0.0f);
}

// Only the edge's two points count.
void TestFieldVariation(RelevoCheck& check)
{
  const FrontView front;
  const Edges triangle = MakeTriangle();
  AddValues(triangle.Mesh);
  vtkNew<vtkFieldVariationDepthTagMetric> field;
  field->SetArrayName("Values");
  field->SetMaximumVariation(1.0);
  CHECK_NEAR(triangle.GetTag(field, front.View, 4, 0, 1), 4.0, 1e-5);
  CHECK_NEAR(triangle.GetTag(field, front.View, 4, 0, 2), 1.0, 1e-5);
  CHECK_NEAR(triangle.GetTag(field, front.View, 4, 1, 2), 3.0, 1e-5);
}

// The smaller cosine of the two ends decides. If only one end faces the eye, the edge is on the
// contour.
void TestSilhouette(RelevoCheck& check)
{
  const FrontView front;
  const Edges triangle = MakeTriangle();
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0, 0, 1);
  normals->InsertNextTuple3(0, 3, 4);
  normals->InsertNextTuple3(0, 0, -1);
  triangle.Mesh->GetPointData()->SetNormals(normals);
  front.Camera->ParallelProjectionOn();
  CHECK_NEAR(triangle.GetTag(silhouette, front.View, 5, 0, 1), 1.0, 1e-5);
  CHECK_EQUAL(triangle.GetTag(silhouette, front.View, 5, 0, 2), 5.0f);
  CHECK_EQUAL(triangle.GetTag(silhouette, front.View, 5, 1, 2), 5.0f);
  silhouette->SetCriterionToContour();
  CHECK_EQUAL(triangle.GetTag(silhouette, front.View, 5, 0, 1), 5.0f); // on the border
}

// A ridge seen along the bisector of its triangles. Only the border is on the contour.
void TestContour(RelevoCheck& check)
{
  const FrontView front;
  const Edges roof = MakeRoof();
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
  silhouette->SetCriterionToContour();
  silhouette->SetContourWidth(1.0);
  front.Camera->ParallelProjectionOn();
  CHECK_NEAR(roof.GetTag(silhouette, front.View, 5, 0, 1), 5.0 * (1.0 - std::sqrt(0.5)), 1e-5);
  CHECK_EQUAL(roof.GetTag(silhouette, front.View, 5, 0, 2), 5.0f);

  front.Camera->ParallelProjectionOff();
  front.Camera->SetPosition(0, 0, 0); // the eye at the middle of the ridge
  front.Camera->SetFocalPoint(0, 0, -1);
  CHECK_EQUAL(roof.GetTag(silhouette, front.View, 5, 0, 1), 5.0f);
}

// The end with the larger bend decides. Both ends of the ridge are bent by 45 degrees, the other
// points are flat.
void TestViewDependent(RelevoCheck& check)
{
  const FrontView front;
  const Edges roof = MakeRoof();
  vtkNew<vtkViewDependentDepthTagMetric> viewDependent;
  viewDependent->SetMaximumSpread(90.0);
  viewDependent->SetEdgeOnWeight(0.0);
  CHECK_NEAR(roof.GetTag(viewDependent, front.View, 4, 0, 1), 2.0, 1e-5);
  CHECK_NEAR(roof.GetTag(viewDependent, front.View, 4, 0, 2), 2.0, 1e-5);
}

// Combines the levels that the metrics give to the edge.
void TestComposite(RelevoCheck& check)
{
  const FrontView front;
  const Edges triangle = MakeTriangle();
  AddValues(triangle.Mesh);
  vtkNew<vtkScreenEdgeDepthTagMetric> screenEdge;
  vtkNew<vtkFieldVariationDepthTagMetric> field;
  field->SetArrayName("Values");
  field->SetMaximumVariation(1.0);
  vtkNew<vtkCompositeDepthTagMetric> composite;
  composite->AddMetric(screenEdge);
  composite->AddMetric(field, 0.5);
  for (int edge = 0; edge < 3; ++edge)
  {
    const int a = edge;
    const int b = (edge + 1) % 3;
    const float first = triangle.GetTag(screenEdge, front.View, 6, a, b);
    const float second = 0.5f * triangle.GetTag(field, front.View, 6, a, b);
    composite->SetModeToMaximum();
    CHECK_NEAR(triangle.GetTag(composite, front.View, 6, a, b), std::max(first, second), 1e-5);
    composite->SetModeToSum();
    CHECK_NEAR(
      triangle.GetTag(composite, front.View, 6, a, b), std::min(first + second, 6.0f), 1e-5);
    // Tags of points and tags of edges are not mixed up.
    const auto tags = TagsOf(composite, triangle.Mesh, front.View, 6);
    CHECK_EQUAL(tags.size(), 3);
    CHECK_NOT_EQUAL(tags, EdgeTagsOf(composite, triangle.Mesh, front.View, 6, triangle.Surface));
  }
}

// By default, an edge has the mean of its points' tags. Coincident points use the larger tag.
void TestDefault(RelevoCheck& check)
{
  auto mesh = RelevoMeshes::Explode(RelevoMeshes::Sphere(9, 7));
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  const relevo::RefinementView view;
  const auto tags = TagsOf(curvature, mesh, view, 5);
  const relevo::SurfaceEdges edges(mesh);
  const auto edgeTags = EdgeTagsOf(curvature, mesh, view, 5, edges);
  CHECK(AreLevels(edgeTags, edges.GetNumberOfEdges(), 5));
  for (int edge = 0; edge < edges.GetNumberOfEdges(); ++edge)
  {
    const int* places = edges.GetEdges()[edge].MergedPoints;
    CHECK_EQUAL(edgeTags[edge], 0.5f * (tags[places[0]] + tags[places[1]]));
  }
}

// A triangle away from an edge, with the smallest and the largest of the values.
void AddExtremes(vtkCellArray* cells, vtkFloatArray* values, const int places[2])
{
  vtkIdType corners[3] = { -1, -1, -1 };
  for (vtkIdType point = 0; point < values->GetNumberOfTuples(); ++point)
  {
    if (point != places[0] && point != places[1])
    {
      const float value = values->GetValue(point);
      corners[value == values->GetRange()[0] ? 0 : value == values->GetRange()[1] ? 1 : 2] = point;
    }
  }
  cells->InsertNextCell(3, corners);
}

// In a mesh of only the triangles at one edge, this edge keeps its tag if the metric depends only
// on the edge and the normals at its ends.
void TestAlone(RelevoCheck& check, vtkDepthTagMetric* metric, const relevo::RefinementView& view,
  bool keepTriangles)
{
  auto sphere = RelevoMeshes::Sphere(9, 7);
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (vtkIdType point = 0; point < sphere->GetNumberOfPoints(); ++point)
  {
    values->InsertNextValue(static_cast<float>((point * 37) % 11));
  }
  sphere->GetPointData()->AddArray(values);
  const relevo::SurfaceEdges edges(sphere);
  const auto tags = EdgeTagsOf(metric, sphere, view, 5, edges);
  CHECK(AreLevels(tags, edges.GetNumberOfEdges(), 5));
  CHECK_GREATER(*std::max_element(tags.begin(), tags.end()), 0.0f);
  for (int edge = 0; edge < edges.GetNumberOfEdges(); ++edge)
  {
    const int* places = edges.GetEdges()[edge].MergedPoints;
    vtkNew<vtkCellArray> cells;
    edges.ForEachSides(edge,
      [&](int i)
      {
        for (int side = 0; side < (keepTriangles ? 2 : 1); ++side)
        {
          if (edges.GetSides()[i].Triangles[side] < 0)
          {
            continue;
          }
          cells->InsertNextCell(
            3, edges.GetTriangles().GetTriangles()[edges.GetSides()[i].Triangles[side]].data());
        }
      });
    AddExtremes(cells, values, places);
    RelevoMeshes::Mesh alone = RelevoMeshes::Make();
    alone->ShallowCopy(sphere);
    alone->SetPolys(cells);
    const relevo::SurfaceEdges few(alone);
    CHECK_EQUAL(
      EdgeTagsOf(metric, alone, view, 5, few)[few.FindEdge(places[0], places[1])], tags[edge]);
  }
}

// Tests all metrics that support this, from random cameras.
void TestAlone(RelevoCheck& check)
{
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
  view.Camera = camera;
  vtkNew<vtkScreenEdgeDepthTagMetric> screenEdge;
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMaximumDistance(5.0);
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette; // the sphere has normals
  vtkNew<vtkSilhouetteDepthTagMetric> contour;
  contour->SetCriterionToContour();
  vtkNew<vtkFieldVariationDepthTagMetric> field;
  field->SetArrayName("Values");
  field->SetMaximumVariation(0.5);
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetCenter(0.5, 0, 0);
  region->SetRadius(0.1);
  region->SetFallOff(0.5);
  std::mt19937 random(7);
  for (int i = 0; i < 4; ++i)
  {
    PlaceAtRandom(camera, random);
    for (vtkDepthTagMetric* metric :
      std::vector<vtkDepthTagMetric*>{ screenEdge, distance, silhouette, contour, field, region })
    {
      TestAlone(check, metric, view, metric == contour);
    }
  }
}
}

int TestDepthTagMetricEdges(int, char*[])
{
  RelevoCheck check;
  TestScreenEdge(check);
  TestDistance(check);
  TestRegion(check);
  TestFieldVariation(check);
  TestSilhouette(check);
  TestContour(check);
  TestViewDependent(check);
  TestComposite(check);
  TestDefault(check);
  TestAlone(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What every metric makes of broken views and meshes: levels, or one error of its own and no tags,
// and always the same for points and for edges.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkPointData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkSphere.h"
#include "vtkTransform.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace
{
struct Named
{
  std::string Name;
  vtkSmartPointer<vtkDepthTagMetric> Metric;
};

// One of every kind, with all its ways to measure.
std::vector<Named> MakeMetrics()
{
  std::vector<Named> metrics;
  for (int fallOff : { 0, 1 })
  {
    for (int measure : { 0, 1 })
    {
      for (double length : { 0.0, 5.0 })
      {
        vtkNew<vtkDistanceDepthTagMetric> distance;
        distance->SetFallOff(fallOff);
        distance->SetMeasure(measure);
        distance->SetReferenceLength(length);
        metrics.push_back({ length > 0.0 ? "pixels" : "distance", distance.Get() });
      }
    }
  }
  metrics.push_back({ "screen", vtkSmartPointer<vtkScreenEdgeDepthTagMetric>::New() });
  for (int criterion : { 0, 1 })
  {
    vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
    silhouette->SetCriterion(criterion);
    metrics.push_back({ "eye", silhouette.Get() });
  }
  metrics.push_back({ "eye", vtkSmartPointer<vtkViewDependentDepthTagMetric>::New() });
  metrics.push_back({ "mesh", vtkSmartPointer<vtkCurvatureDepthTagMetric>::New() });
  vtkNew<vtkFieldVariationDepthTagMetric> field;
  field->SetArrayName("Values");
  metrics.push_back({ "field", field.Get() });
  vtkNew<vtkRegionDepthTagMetric> ball;
  ball->SetRadius(0.2);
  metrics.push_back({ "mesh", ball.Get() });
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetImplicitFunction(vtkNew<vtkSphere>());
  metrics.push_back({ "mesh", region.Get() });
  vtkNew<vtkCompositeDepthTagMetric> composite;
  for (const Named& named : metrics)
  {
    composite->AddMetric(named.Metric);
  }
  metrics.push_back({ "all", composite.Get() });
  return metrics;
}

RelevoMeshes::Mesh MakeMesh(float value)
{
  auto mesh = RelevoMeshes::Sphere(9, 7); // of a radius of 1/2 around the origin
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  values->SetNumberOfTuples(mesh->GetNumberOfPoints());
  values->FillValue(value);
  mesh->GetPointData()->AddArray(values);
  return mesh;
}

// Levels for every metric but those named, which give an error that says `words`.
void TestView(RelevoCheck& check, vtkPolyData* mesh, const relevo::RefinementView& view,
  const std::vector<std::string>& failing = {}, const std::string& words = "")
{
  relevo::SurfaceEdges edges;
  edges.Update(mesh);
  for (const Named& named : MakeMetrics())
  {
    RelevoErrors errors(named.Metric);
    std::vector<std::unique_ptr<RelevoErrors>> parts; // kept from being printed
    if (auto* composite = vtkCompositeDepthTagMetric::SafeDownCast(named.Metric))
    {
      for (int i = 0; i < composite->GetNumberOfMetrics(); ++i)
      {
        parts.push_back(std::make_unique<RelevoErrors>(composite->GetMetric(i)));
      }
    }
    const bool fails = !failing.empty() &&
      (named.Name == "all" ||
        std::find(failing.begin(), failing.end(), named.Name) != failing.end());
    for (bool ofEdges : { false, true })
    {
      const auto tags = ofEdges ? EdgeTagsOf(named.Metric, mesh, view, 5, edges)
                                : TagsOf(named.Metric, mesh, view, 5);
      const vtkIdType number = ofEdges ? edges.GetNumberOfEdges() : mesh->GetNumberOfPoints();
      if (fails)
      {
        CHECK(tags.empty());
        CHECK(errors.Said(named.Name == "all" ? "see its own error" : words));
      }
      else
      {
        CHECK(AreLevels(tags, number, 5));
        CHECK(errors.None());
      }
    }
  }
}
}

int TestDepthTagMetricErrors(int, char*[])
{
  RelevoCheck check;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto mesh = MakeMesh(1.0f);
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
  view.Camera = camera;
  const std::vector<std::string> ofTheView{ "distance", "pixels", "screen", "eye" };

  // The camera inside the mesh, on a vertex, in the middle of a face, on its focal point; far away
  // and close by; of any kind.
  for (bool parallel : { false, true })
  {
    camera->SetParallelProjection(parallel);
    camera->SetFocalPoint(0, 0, -1);
    camera->SetPosition(0, 0, 0);
    TestView(check, mesh, view);
    camera->SetPosition(mesh->GetPoint(5));
    TestView(check, mesh, view);
    camera->SetPosition(0, 0, 1e12);
    TestView(check, mesh, view);
    camera->SetPosition(0, 0, 1e200);
    TestView(check, mesh, view, { "screen" }, "its view is flat");
    camera->SetPosition(0, 0, 2);
    for (double angle : { 1e-8, 179.9 })
    {
      camera->SetViewAngle(angle);
      TestView(check, mesh, view);
    }
    camera->SetViewAngle(30);
    camera->SetParallelScale(1e-30);
    TestView(check, mesh, view);
    camera->SetParallelScale(1);
    camera->SetClippingRange(1e-20, 1e20);
    TestView(check, mesh, view);
    camera->SetClippingRange(0.01, 1000);
    // No direction: distances do not need one.
    camera->SetFocalPoint(0, 0, 2);
    TestView(check, mesh, view, { "screen", "eye" }, "no direction");
    camera->SetFocalPoint(nan, 0, 0);
    TestView(check, mesh, view, { "screen", "eye" }, "not finite");
    camera->SetFocalPoint(0, 0, 0);
    camera->SetPosition(nan, 0, 0);
    TestView(check, mesh, view, ofTheView, "not finite");
    camera->SetPosition(0, 0, 2);
    camera->SetViewUp(0, 0, 1);
    TestView(check, mesh, view, { "screen" }, "view-up");
    camera->SetViewUp(0, 1, 0);
  }
  view.Camera = nullptr;
  TestView(check, mesh, view, ofTheView, "no camera");
  view.Camera = camera;

  // A viewport without an area.
  for (int width : { 0, -5 })
  {
    view.ViewportSize[0] = width;
    TestView(check, mesh, view, { "screen" }, "no pixels");
    std::swap(view.ViewportSize[0], view.ViewportSize[1]);
    TestView(check, mesh, view, { "screen", "pixels" }, "no pixels");
    view.ViewportSize[0] = view.ViewportSize[1] = 300;
  }

  // Matrices that flatten, mirror, blow up or are broken.
  for (const std::array<double, 3>& scale :
    std::vector<std::array<double, 3>>{ { { 1, 1, 0 } }, { { 0, 0, 0 } }, { { -1, 1, 1 } },
      { { 1e20, 1, 1e-20 } }, { { 1e-200, 1, 1 } }, { { nan, 1, 1 } } })
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int c = 0; c < 3; ++c)
    {
      matrix->SetElement(c, c, scale[c]);
    }
    view.ModelToWorld = matrix;
    TestView(check, mesh, view);
  }
  view.ModelToWorld = nullptr;

  // Meshes that are tiny, huge, far away; without an array, and with one of nothing but NaN.
  for (double scale : { 1e-30, 1e-12, 1e12, 1e30 })
  {
    const double none[3] = { 0, 0, 0 };
    auto scaled = RelevoMeshes::Moved(mesh, scale, none, VTK_DOUBLE);
    scaled->GetPointData()->AddArray(mesh->GetPointData()->GetArray("Values"));
    TestView(check, scaled, view);
    camera->SetPosition(0, 0, 2 * scale);
    if (scale > 1e-20)
    {
      TestView(check, scaled, view);
    }
    camera->SetPosition(0, 0, 2);
  }
  TestView(check, MakeMesh(std::nanf("")), view);
  TestView(check, RelevoMeshes::Sphere(9, 7), view, { "field" }, "no point or cell array");
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthTagMetric promises for unusable views and meshes either levels or one error without tags,
// the same for points and for edges.
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

// One metric of every kind, with all its modes.
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
  auto mesh = RelevoMeshes::Sphere(9, 7); // a sphere with radius 1/2 around the origin
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  values->SetNumberOfTuples(mesh->GetNumberOfPoints());
  values->FillValue(value);
  mesh->GetPointData()->AddArray(values);
  return mesh;
}

// Expects levels from every metric except those named, which report `words`.
void TestView(RelevoCheck& check, vtkPolyData* mesh, const relevo::RefinementView& view,
  const std::vector<std::string>& failing = {}, const std::string& words = "")
{
  const relevo::SurfaceEdges edges(mesh);
  for (const Named& named : MakeMetrics())
  {
    RelevoErrors errors(named.Metric);
    std::vector<std::unique_ptr<RelevoErrors>> parts; // captures errors without printing them
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
      CHECK_CASE(ofEdges);
      const auto tags = ofEdges ? EdgeTagsOf(named.Metric, mesh, view, 5, edges)
                                : TagsOf(named.Metric, mesh, view, 5);
      const vtkIdType number = ofEdges ? edges.GetNumberOfEdges() : mesh->GetNumberOfPoints();
      if (fails)
      {
        CHECK(tags.empty());
        CHECK(errors.Said(named.Name == "all" ? "its own error gives the reason" : words));
      }
      else
      {
        CHECK(AreLevels(tags, number, 5));
        CHECK(errors.None());
      }
    }
  }
}

// A mesh, a camera that sees it, and the expected results of the metrics.
struct Scene
{
  Scene() { this->View.Camera = this->Camera; }
  void Expect(RelevoCheck& check, const std::vector<std::string>& failing = {},
    const std::string& words = "") const
  {
    TestView(check, this->Mesh, this->View, failing, words);
  }

  RelevoMeshes::Mesh Mesh = MakeMesh(1.0f);
  vtkNew<vtkCamera> Camera;
  relevo::RefinementView View;
};

const double NaN = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> ViewDependent{ "distance", "pixels", "screen", "eye" };

// The camera is inside the mesh, on a vertex, on a face, at its focal point, far away, close, or of
// another kind.
void TestCameras(RelevoCheck& check, Scene& scene)
{
  vtkCamera* camera = scene.Camera;
  for (bool parallel : { false, true })
  {
    camera->SetParallelProjection(parallel);
    camera->SetFocalPoint(0, 0, -1);
    camera->SetPosition(0, 0, 0);
    scene.Expect(check);
    camera->SetPosition(scene.Mesh->GetPoint(5));
    scene.Expect(check);
    camera->SetPosition(0, 0, 1e12);
    scene.Expect(check);
    camera->SetPosition(0, 0, 1e200);
    scene.Expect(check, { "screen" }, "its view transform is singular");
    camera->SetPosition(0, 0, 2);
    for (double angle : { 1e-8, 179.9 })
    {
      CHECK_CASE(angle);
      camera->SetViewAngle(angle);
      scene.Expect(check);
    }
    camera->SetViewAngle(30);
    camera->SetParallelScale(1e-30);
    scene.Expect(check);
    camera->SetParallelScale(1);
    camera->SetClippingRange(1e-20, 1e20);
    scene.Expect(check);
    camera->SetClippingRange(0.01, 1000);
    // The camera has no direction. Distances do not need one.
    camera->SetFocalPoint(0, 0, 2);
    scene.Expect(check, { "screen", "eye" }, "no direction");
    camera->SetFocalPoint(NaN, 0, 0);
    scene.Expect(check, { "screen", "eye" }, "not finite");
    camera->SetFocalPoint(0, 0, 0);
    camera->SetPosition(NaN, 0, 0);
    scene.Expect(check, ViewDependent, "not finite");
    camera->SetPosition(0, 0, 2);
    camera->SetViewUp(0, 0, 1);
    scene.Expect(check, { "screen" }, "view-up");
    camera->SetViewUp(0, 1, 0);
  }
  scene.View.Camera = nullptr;
  scene.Expect(check, ViewDependent, "no camera");
  scene.View.Camera = camera;
}

// The viewport has no area.
void TestViewports(RelevoCheck& check, Scene& scene)
{
  int* size = scene.View.ViewportSize;
  for (int width : { 0, -5 })
  {
    CHECK_CASE(width);
    size[0] = width;
    scene.Expect(check, { "screen" }, "no pixels");
    std::swap(size[0], size[1]);
    scene.Expect(check, { "screen", "pixels" }, "no pixels");
    size[0] = size[1] = 300;
  }
}

// Matrices that flatten, mirror or scale extremely, and matrices with NaN.
void TestMatrices(RelevoCheck& check, Scene& scene)
{
  for (const std::array<double, 3>& scale :
    std::vector<std::array<double, 3>>{ { { 1, 1, 0 } }, { { 0, 0, 0 } }, { { -1, 1, 1 } },
      { { 1e20, 1, 1e-20 } }, { { 1e-200, 1, 1 } }, { { NaN, 1, 1 } } })
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int c = 0; c < 3; ++c)
    {
      matrix->SetElement(c, c, scale[c]);
    }
    scene.View.ModelToWorld = matrix;
    scene.Expect(check);
  }
  scene.View.ModelToWorld = nullptr;
}

// Meshes that are tiny, huge or far away, without the array, or with an array of NaN only.
void TestMeshes(RelevoCheck& check, Scene& scene)
{
  for (double scale : { 1e-30, 1e-12, 1e12, 1e30 })
  {
    CHECK_CASE(scale);
    const double none[3] = { 0, 0, 0 };
    auto scaled = RelevoMeshes::Moved(scene.Mesh, scale, none, VTK_DOUBLE);
    scaled->GetPointData()->AddArray(scene.Mesh->GetPointData()->GetArray("Values"));
    TestView(check, scaled, scene.View);
    scene.Camera->SetPosition(0, 0, 2 * scale);
    if (scale > 1e-20)
    {
      TestView(check, scaled, scene.View);
    }
    scene.Camera->SetPosition(0, 0, 2);
  }
  TestView(check, MakeMesh(std::nanf("")), scene.View);
  TestView(check, RelevoMeshes::Sphere(9, 7), scene.View, { "field" }, "no point or cell array");
}
}

int TestDepthTagMetricErrors(int, char*[])
{
  RelevoCheck check;
  Scene scene;
  TestCameras(check, scene); // leaves the camera in the position that the other tests need
  TestViewports(check, scene);
  TestMatrices(check, scene);
  TestMeshes(check, scene);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that cached results of metric evaluators are correct: after every change of mesh, view and
// settings, they equal those of new evaluators.
#include "RelevoAllMetrics.h"
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <memory>

namespace
{
using Metrics = std::vector<vtkSmartPointer<vtkDepthTagMetric>>;

Metrics MakeMetrics()
{
  Metrics metrics = RelevoMakeAllMetrics("Values");
  metrics.push_back(RelevoMakeSum(metrics, 0.05));
  return metrics;
}

class Watch
{
public:
  Watch()
  {
    for (vtkDepthTagMetric* metric : MakeMetrics())
    {
      this->Kept.push_back(std::make_unique<KeptMetric>(metric));
    }
  }

  // The number of metrics whose tags have changed since the last call.
  int Compare(RelevoCheck& check, vtkPolyData* mesh, const relevo::RefinementView& view)
  {
    const relevo::SurfaceEdges edges(mesh);
    const Metrics fresh = MakeMetrics();
    int changes = 0;
    this->Last.resize(fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i)
    {
      const auto tags = this->Kept[i]->GetTags(mesh, view, 5);
      CHECK_EQUAL(tags, TagsOf(fresh[i], mesh, view, 5));
      CHECK_EQUAL(
        this->Kept[i]->GetEdgeTags(mesh, view, 5), EdgeTagsOf(fresh[i], mesh, view, 5, edges));
      CHECK(AreLevels(tags, mesh->GetNumberOfPoints(), 5));
      changes += tags != this->Last[i];
      this->Last[i] = tags;
    }
    return changes;
  }

private:
  std::vector<std::unique_ptr<KeptMetric>> Kept;
  std::vector<std::vector<float>> Last;
};

void AddValues(vtkPolyData* mesh, int seed)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    values->InsertNextValue(static_cast<float>((point * seed) % 11));
  }
  mesh->GetPointData()->AddArray(values);
}

// An unused point is not drawn and affects no tags of used points.
void CheckUnusedPoints(RelevoCheck& check, const relevo::RefinementView& view)
{
  auto mesh = RelevoMeshes::Sphere(9, 7);
  AddValues(mesh, 7);
  vtkNew<vtkPolyData> more;
  more->DeepCopy(mesh);
  more->GetPoints()->InsertNextPoint(40.0, -30.0, 20.0);
  vtkFloatArray::SafeDownCast(more->GetPointData()->GetArray("Values"))->InsertNextValue(500.0f);
  more->GetPointData()->SetNormals(nullptr);
  mesh->GetPointData()->SetNormals(nullptr);
  for (vtkDepthTagMetric* metric : MakeMetrics())
  {
    const auto expected = TagsOf(metric, mesh, view, 5);
    auto tags = TagsOf(metric, more, view, 5);
    CHECK_EQUAL(tags.size(), expected.size() + 1);
    tags.resize(expected.size());
    for (std::size_t i = 0; i < tags.size(); ++i)
    {
      CHECK_NEAR(tags[i], expected[i], 1e-3);
    }
  }
}
}

int TestDepthTagMetricUpdates(int, char*[])
{
  RelevoCheck check;
  auto mesh = RelevoMeshes::Explode(RelevoMeshes::Sphere(9, 7));
  AddValues(mesh, 7);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(1, 0.5, 2);
  camera->SetClippingRange(0.1, 10);
  relevo::RefinementView view;
  view.Camera = camera;
  CheckUnusedPoints(check, view);
  Watch watch;
  const int all = static_cast<int>(MakeMetrics().size());
  CHECK_EQUAL(watch.Compare(check, mesh, view), all);
  CHECK_EQUAL(watch.Compare(check, mesh, view), 0);

  // The view affects all metrics except curvature, field variation and region.
  camera->SetPosition(1.1, 0.5, 2);
  CHECK_EQUAL(watch.Compare(check, mesh, view), 8);
  camera->ParallelProjectionOn();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 4);
  camera->ParallelProjectionOff();
  watch.Compare(check, mesh, view);
  view.ViewportSize[1] = 500;
  CHECK_EQUAL(watch.Compare(check, mesh, view), 3); // pixels, screen, and the sum of both

  // Rotating, scaling, moving and stretching the actor does not affect curvature and field
  // variation.
  vtkNew<vtkTransform> transform;
  view.ModelToWorld = transform->GetMatrix();
  transform->RotateY(40);
  transform->Update();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 8);
  transform->Scale(1.5, 1.5, 1.5);
  transform->Update();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 7);
  transform->Translate(0.1, 0.2, 0.3);
  transform->Update();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 7);
  transform->Scale(1, 3, 0.5);
  transform->Update();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 8);
  transform->Scale(-1, 1, 1);
  transform->Update();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 7);

  // Changes the mesh's points, normals, values and polygons, and then the mesh.
  double x[3];
  mesh->GetPoint(3, x);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    double y[3];
    mesh->GetPoint(point, y);
    if (y[0] == x[0] && y[1] == x[1] && y[2] == x[2])
    {
      mesh->GetPoints()->SetPoint(point, 1.2 * x[0], x[1] + 0.1, x[2]);
    }
  }
  mesh->GetPoints()->Modified();
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 7);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (CHECK(normals))
  {
    normals->SetTuple3(0, 1, 2, 3);
    normals->Modified();
    CHECK_EQUAL(watch.Compare(check, mesh, view), 2); // the silhouette and the sum
    mesh->GetPointData()->SetNormals(nullptr);
    CHECK_EQUAL(watch.Compare(check, mesh, view), 2);
  }
  AddValues(mesh, 5);
  CHECK_EQUAL(watch.Compare(check, mesh, view), 2);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 5, 4, 3 });
  mesh->SetPolys(polygons);
  CHECK_GREATER_EQUAL(watch.Compare(check, mesh, view), 7);
  auto other = RelevoMeshes::Plane(5, 4);
  AddValues(other, 3);
  CHECK_EQUAL(watch.Compare(check, other, view), all);
  return check.GetResult();
}

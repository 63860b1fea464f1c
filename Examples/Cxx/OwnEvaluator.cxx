// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Example of a custom, view-dependent metric: high levels where the surface is seen edge-on. It
 * needs the mesh's normals, which its evaluator computes once rather than for every view. Prints
 * the number of triangles of a sphere seen from near and from far.
 */
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include "Mesh/SurfaceTriangles.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "View/RefinementView.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace
{
class EdgeOnMetric : public vtkDepthTagMetric
{
public:
  static EdgeOnMetric* New();
  vtkTypeMacro(EdgeOnMetric, vtkDepthTagMetric);

  bool IsViewDependent() override { return true; }
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;

  // Levels are proportional to this power of the sine of the angle between normal and view
  // direction.
  double Power = 4.0;
};

class EdgeOnEvaluator : public relevo::MetricEvaluator
{
public:
  EdgeOnEvaluator(EdgeOnMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    this->UpdateNormals();
    double eye[4] = { 0.0, 0.0, 0.0, 1.0 }; // in the mesh's coordinates
    view.Camera->GetPosition(eye);
    if (view.ModelToWorld)
    {
      vtkNew<vtkMatrix4x4> worldToModel;
      vtkMatrix4x4::Invert(view.ModelToWorld, worldToModel);
      worldToModel->MultiplyPoint(eye, eye);
    }
    vtkPolyData* mesh = this->GetMesh().GetPolyData();
    tags->SetNumberOfComponents(1);
    tags->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double toEye[3];
      double point[3];
      mesh->GetPoint(i, point);
      vtkMath::Subtract(eye, point, toEye);
      vtkMath::Normalize(toEye);
      const double cosine = vtkMath::Dot(toEye, this->Normals[i].data());
      const double sine = std::sqrt(1.0 - std::min(cosine * cosine, 1.0));
      tags->SetValue(i, static_cast<float>(maximumLevel * std::pow(sine, this->Metric->Power)));
    }
    tags->Modified();
    return true;
  }

private:
  // Computes point normals from the triangles around the points.
  void UpdateNormals()
  {
    relevo::MetricMesh& mesh = this->GetMesh();
    if (this->NormalsTime == mesh.GetTime())
    {
      return;
    }
    this->NormalsTime = mesh.GetTime();
    const relevo::SurfaceTriangles& surface = *mesh.GetTriangles();
    this->Normals.assign(surface.GetNumberOfPoints(), { 0.0, 0.0, 0.0 });
    for (const auto& triangle : surface.GetTriangles()) // its corners are merged points
    {
      double points[3][3];
      for (int corner = 0; corner < 3; ++corner)
      {
        surface.GetPoint(triangle[corner], points[corner]);
      }
      double sides[2][3];
      vtkMath::Subtract(points[1], points[0], sides[0]);
      vtkMath::Subtract(points[2], points[0], sides[1]);
      double normal[3];
      vtkMath::Cross(sides[0], sides[1], normal);
      for (vtkIdType place : triangle)
      {
        vtkMath::Add(this->Normals[place].data(), normal, this->Normals[place].data());
      }
    }
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i)
    {
      // The merged point is the one with the lowest id.
      this->Normals[i] = this->Normals[surface.GetMergedPoint(i)];
      vtkMath::Normalize(this->Normals[i].data());
    }
  }

  EdgeOnMetric* Metric;
  std::vector<std::array<double, 3>> Normals;
  vtkMTimeType NormalsTime = 0;
};

vtkStandardNewMacro(EdgeOnMetric);

std::unique_ptr<relevo::MetricEvaluator> EdgeOnMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<EdgeOnEvaluator>(this, mesh);
}
}

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  vtkNew<EdgeOnMetric> metric;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMetric(metric);
  recipe->SetMaximumLevel(4);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputConnection(sphere->GetOutputPort());
  refine->SetRefinement(recipe);
  refine->SetCamera(camera);

  // From close by, less of the sphere is seen edge-on.
  vtkIdType triangles[2];
  for (int i = 0; i < 2; ++i)
  {
    camera->SetPosition(0.0, 0.0, i == 0 ? 0.6 : 100.0);
    refine->Update();
    triangles[i] = refine->GetOutput()->GetNumberOfPolys();
  }
  std::cout << triangles[0] << " triangles from close by, " << triangles[1] << " from far away\n";
  return triangles[0] > 0 && triangles[0] < triangles[1] ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewDependentDepthTagMetric.h"

#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Mesh/SurfaceNormals.h"
#include "Metrics/FunctionEvaluator.h"
#include "Metrics/MetricFrame.h"
#include "View/RefinementView.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include "relevoMetricView.h"
#include "relevoViewDependentMetric.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace relevo
{
struct ViewDependentFunctions : MetricParameters
{
  using MetricParameters::MetricParameters;
#include "glsl/Metrics/relevoMetricView.glsl"

#include "glsl/Metrics/relevoViewDependentMetric.glsl"
};
}

namespace
{
using glm::dmat3;
using glm::dvec3;

constexpr double SmallestSpread = 0.01; // degrees

// The angle in radians. A zero vector has the largest angle to all others.
double AngleBetween(const dvec3& a, const dvec3& b)
{
  return a == dvec3(0.0) ? vtkMath::Pi()
                         : std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Mean normals and spreads of points for relevoViewDependentMetric.glsl.
class Spreads
{
public:
  void Update(relevo::MetricMesh& mesh, const relevo::Placement& placement, double maximumSpread)
  {
    const bool changed =
      this->DataDependencies.Update(relevo::Dependencies::On(mesh.GetTime(), maximumSpread));
    if (changed || !placement.HasShape(this->Shape))
    {
      this->Shape = placement.GetShape();
      this->Build(relevo::GetShape(mesh).GetNormals(), placement, maximumSpread);
    }
  }

  const std::shared_ptr<const std::vector<float>>& GetData() const { return this->Data; }

private:
  void Build(
    const relevo::SurfaceNormals& surface, const relevo::Placement& placement, double maximumSpread)
  {
    const relevo::SurfaceTriangles& triangles = surface.GetTriangles();
    const auto data = std::make_shared<std::vector<float>>(
      4 * static_cast<std::size_t>(triangles.GetNumberOfPoints()));
    this->Data = data;
    vtkSMPTools::For(0, triangles.GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          const vtkIdType place = triangles.GetMergedPoint(point);
          const dvec3 mean = relevo::UnitOrZero(surface.GetAreaVectorAt(place));
          float* datum = data->data() + 4 * point;
          for (int c = 0; c < 3; ++c)
          {
            datum[c] = static_cast<float>(mean[c]);
          }
          datum[3] = static_cast<float>(GetSpread(surface, place, mean, placement) / maximumSpread);
        }
      });
  }

  // In world coordinates.
  static double GetSpread(const relevo::SurfaceNormals& surface, vtkIdType place, const dvec3& mean,
    const relevo::Placement& placement)
  {
    const dvec3 worldMean = relevo::UnitOrZero(placement.GetNormal(mean));
    double spread = 0.0;
    surface.GetTriangles().ForEachTriangleIndex(place,
      [&](vtkIdType t)
      {
        const dvec3 normal = relevo::UnitOrZero(placement.GetNormal(surface.GetAreaVectors()[t]));
        if (normal != dvec3(0.0))
        {
          spread = std::max(spread, AngleBetween(worldMean, normal));
        }
      });
    return spread;
  }

  std::shared_ptr<const std::vector<float>> Data;
  relevo::Dependencies DataDependencies; // except the shape, which is compared with a tolerance
  dmat3 Shape{ 0.0 };
};

class ViewDependentEvaluator : public relevo::FunctionEvaluator<relevo::ViewDependentFunctions>
{
public:
  ViewDependentEvaluator(
    vtkViewDependentDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FunctionEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool GetShader(const relevo::RefinementView& view, int maximumLevel, const double origin[3],
    relevo::MetricShader& shader) override
  {
    relevo::Eye eye;
    std::string error;
    if (!eye.Set(view, error))
    {
      vtkErrorWithObjectMacro(this->Metric.Get(), << error << ".");
      return false;
    }
    shader.Source = std::string(relevoMetricView) + relevoViewDependentMetric;
    shader.TagsPoints = true;
    const relevo::Placement placement(view);
    this->PointSpreads.Update(
      this->GetMesh(), placement, vtkMath::RadiansFromDegrees(this->Metric->GetMaximumSpread()));
    shader.Data = this->PointSpreads.GetData();
    relevo::MetricFrame frame(shader, placement, eye.GetPosition(), origin, maximumLevel);
    const double diagonal = placement.GetDiagonal(relevo::GetShape(this->GetMesh()).GetPointBox());
    frame.SetUnit(diagonal > 0.0 ? diagonal : 1.0);
    frame.SetDirections(eye);
    frame.SetOwn(this->Metric->GetEdgeOnWeight());
    return true;
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->TagPoints(view, maximumLevel, tags);
  }

private:
  vtkSmartPointer<vtkViewDependentDepthTagMetric> Metric;
  Spreads PointSpreads;
};
}

vtkStandardNewMacro(vtkViewDependentDepthTagMetric);

vtkViewDependentDepthTagMetric::vtkViewDependentDepthTagMetric() = default;
vtkViewDependentDepthTagMetric::~vtkViewDependentDepthTagMetric() = default;

void vtkViewDependentDepthTagMetric::SetMaximumSpread(double degrees)
{
  relevo::SetInRange(this, "MaximumSpread", this->MaximumSpread, degrees, SmallestSpread, 180.0);
}

void vtkViewDependentDepthTagMetric::SetEdgeOnWeight(double weight)
{
  relevo::SetInRange(this, "EdgeOnWeight", this->EdgeOnWeight, weight, 0.0, 1.0);
}

std::unique_ptr<relevo::MetricEvaluator> vtkViewDependentDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<ViewDependentEvaluator>(this, mesh);
}

void vtkViewDependentDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumSpread: " << this->MaximumSpread << "\n";
  os << indent << "EdgeOnWeight: " << this->EdgeOnWeight << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewDependentDepthTagMetric.h"

#include "Core/RefinementView.h"
#include "Core/SettingChecks.h"
#include "Mesh/SurfaceNormals.h"
#include "Metrics/MetricEvaluation.h"
#include "Metrics/MetricFrame.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

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
#include "glsl/relevoMetricView.glsl"

#include "glsl/relevoViewDependentMetric.glsl"
};
}

namespace
{
using glm::dmat3;
using glm::dvec3;

constexpr double SmallestSpread = 0.01; // degrees

// The angle in radians; a zero vector is at the greatest angle from every other.
double AngleBetween(const dvec3& a, const dvec3& b)
{
  return a == dvec3(0.0) ? vtkMath::Pi()
                         : std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Mean normals and spreads of points, as relevoViewDependentMetric.glsl wants them.
class Spreads
{
public:
  void Update(vtkPolyData* mesh, const relevo::Placement& placement, double maximumSpread)
  {
    if (this->Surface.Update(mesh) || !placement.HasShape(this->Shape) ||
      maximumSpread != this->MaximumSpread)
    {
      this->Shape = placement.GetShape();
      this->MaximumSpread = maximumSpread;
      this->Build(placement);
      this->Time.Modified();
    }
  }

  const std::shared_ptr<const std::vector<float>>& GetData() const { return this->Data; }
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

private:
  void Build(const relevo::Placement& placement)
  {
    const relevo::SurfaceTriangles& triangles = this->Surface.GetTriangles();
    const auto data = std::make_shared<std::vector<float>>(
      4 * static_cast<std::size_t>(triangles.GetNumberOfPoints()));
    this->Data = data;
    vtkSMPTools::For(0, triangles.GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          const vtkIdType place = triangles.GetPlace(point);
          const dvec3 mean = relevo::UnitOrZero(this->Surface.GetAreaVectorAt(place));
          float* datum = data->data() + 4 * point;
          for (int c = 0; c < 3; ++c)
          {
            datum[c] = static_cast<float>(mean[c]);
          }
          datum[3] =
            static_cast<float>(this->GetSpread(place, mean, placement) / this->MaximumSpread);
        }
      });
  }

  // In the world's coordinates.
  double GetSpread(vtkIdType place, const dvec3& mean, const relevo::Placement& placement) const
  {
    const dvec3 worldMean = relevo::UnitOrZero(placement.GetNormal(mean));
    double spread = 0.0;
    this->Surface.GetTriangles().ForEachTriangleIndex(place,
      [&](vtkIdType t)
      {
        const dvec3 normal =
          relevo::UnitOrZero(placement.GetNormal(this->Surface.GetAreaVectors()[t]));
        if (normal != dvec3(0.0))
        {
          spread = std::max(spread, AngleBetween(worldMean, normal));
        }
      });
    return spread;
  }

  relevo::SurfaceNormals Surface;
  dmat3 Shape{ 0.0 };
  double MaximumSpread = 0.0;
  std::shared_ptr<const std::vector<float>> Data;
  vtkTimeStamp Time;
};
}

struct vtkViewDependentDepthTagMetric::vtkInternals
  : relevo::MetricEvaluation<relevo::ViewDependentFunctions>
{
  Spreads Of;
};

vtkStandardNewMacro(vtkViewDependentDepthTagMetric);

vtkViewDependentDepthTagMetric::vtkViewDependentDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkViewDependentDepthTagMetric::~vtkViewDependentDepthTagMetric() = default;

void vtkViewDependentDepthTagMetric::SetMaximumSpread(double degrees)
{
  relevo::SetInRange(this, "MaximumSpread", this->MaximumSpread, degrees, SmallestSpread, 180.0);
}

void vtkViewDependentDepthTagMetric::SetEdgeOnWeight(double weight)
{
  relevo::SetInRange(this, "EdgeOnWeight", this->EdgeOnWeight, weight, 0.0, 1.0);
}

bool vtkViewDependentDepthTagMetric::GetShader(vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel, const double origin[3],
  relevo::MetricShader& shader)
{
  relevo::Eye eye;
  std::string error;
  if (!eye.Set(view, error))
  {
    vtkErrorMacro(<< error << ".");
    return false;
  }
  static const std::string source = std::string(relevoMetricView) + relevoViewDependentMetric;
  shader.Source = source.c_str();
  shader.TagsPoints = true;
  const relevo::Placement placement(view);
  Spreads& spreads = this->Internals->Of;
  spreads.Update(mesh, placement, vtkMath::RadiansFromDegrees(this->MaximumSpread));
  shader.Data = spreads.GetData();
  shader.DataTime = spreads.GetTime();
  relevo::MetricFrame frame(shader, placement, eye.GetPosition(), origin, maximumLevel);
  const double diagonal = placement.GetDiagonal(mesh);
  frame.SetUnit(diagonal > 0.0 ? diagonal : 1.0);
  frame.SetDirections(eye);
  frame.SetOwn(this->EdgeOnWeight);
  return true;
}

bool vtkViewDependentDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  return this->Internals->TagPoints(this, mesh, view, maximumLevel, tags);
}

bool vtkViewDependentDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel, const relevo::SurfaceEdges& edges,
  vtkFloatArray* tags)
{
  return this->Internals->TagEdges(this, mesh, view, maximumLevel, edges, tags);
}

void vtkViewDependentDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumSpread: " << this->MaximumSpread << "\n";
  os << indent << "EdgeOnWeight: " << this->EdgeOnWeight << "\n";
}

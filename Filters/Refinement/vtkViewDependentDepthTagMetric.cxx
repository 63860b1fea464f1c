// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewDependentDepthTagMetric.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementView.h"
#include "vtkSurfaceEdges.h"
#include "vtkWorldView.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

namespace
{
using glm::dvec3;

constexpr double SmallestSpread = 0.01; // degrees

// The angle in radians; a zero vector is at the greatest angle from every other.
double AngleBetween(const dvec3& a, const dvec3& b)
{
  return a == dvec3(0.0) ? vtkMath::Pi()
                         : std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}
}

struct vtkViewDependentDepthTagMetric::vtkInternals
{
  relevo::SurfaceEdges Edges;
};

vtkStandardNewMacro(vtkViewDependentDepthTagMetric);

vtkViewDependentDepthTagMetric::vtkViewDependentDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkViewDependentDepthTagMetric::~vtkViewDependentDepthTagMetric() = default;

void vtkViewDependentDepthTagMetric::SetMaximumSpread(double degrees)
{
  if (!(degrees >= SmallestSpread && degrees <= 180.0))
  {
    vtkErrorMacro(
      "MaximumSpread " << degrees << " is outside [" << SmallestSpread << ", 180] degrees.");
    return;
  }
  if (this->MaximumSpread != degrees)
  {
    this->MaximumSpread = degrees;
    this->Modified();
  }
}

void vtkViewDependentDepthTagMetric::SetEdgeOnWeight(double weight)
{
  if (!(weight >= 0.0 && weight <= 1.0))
  {
    vtkErrorMacro("EdgeOnWeight " << weight << " is outside [0, 1].");
    return;
  }
  if (this->EdgeOnWeight != weight)
  {
    this->EdgeOnWeight = weight;
    this->Modified();
  }
}

bool vtkViewDependentDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  relevo::Eye eye;
  std::string error;
  if (!eye.Set(view, error))
  {
    vtkErrorMacro(<< error << ".");
    return false;
  }
  this->Internals->Edges.Update(mesh);
  const relevo::SurfaceTriangles& surface = this->Internals->Edges.GetTriangles();
  const std::vector<dvec3> points = relevo::Placement(view).GetPoints(surface);
  const std::vector<dvec3> areaVectors = relevo::ComputeAreaVectors(surface, points);
  const float maximumSpread = static_cast<float>(vtkMath::RadiansFromDegrees(this->MaximumSpread));
  const float weight = static_cast<float>(this->EdgeOnWeight);
  const auto levelOf = [&](vtkIdType place)
  {
    dvec3 sum(0.0);
    surface.ForEachTriangleIndex(place, [&](vtkIdType t) { sum += areaVectors[t]; });
    const dvec3 mean = relevo::UnitOrZero(sum);
    double spread = 0.0;
    surface.ForEachTriangleIndex(place,
      [&](vtkIdType t)
      {
        const dvec3 normal = relevo::UnitOrZero(areaVectors[t]);
        if (normal != dvec3(0.0))
        {
          spread = std::max(spread, AngleBetween(mean, normal));
        }
      });
    const double cosine = glm::dot(mean, eye.GetDirectionFrom(points[place]));
    return relevo::viewDependentLevel(
      static_cast<float>(spread), maximumSpread, static_cast<float>(cosine), weight, maximumLevel);
  };
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(surface.GetNumberOfPoints());
  vtkSMPTools::For(0, surface.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        tags->SetValue(point, levelOf(surface.GetPlace(point)));
      }
    });
  tags->Modified();
  return true;
}

bool vtkViewDependentDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh,
  const vtkRefinementView& view, int maximumLevel, const relevo::SurfaceEdges& edges,
  vtkFloatArray* tags)
{
  vtkNew<vtkFloatArray> pointTags;
  if (!this->ComputeTags(mesh, view, maximumLevel, pointTags))
  {
    return false;
  }
  const float* ofPoints = pointTags->GetPointer(0);
  relevo::TagEdges(edges, tags,
    [&](int edge)
    {
      const int* places = edges.GetEdges()[edge].Places;
      return std::max(ofPoints[places[0]], ofPoints[places[1]]);
    });
  return true;
}

void vtkViewDependentDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumSpread: " << this->MaximumSpread << "\n";
  os << indent << "EdgeOnWeight: " << this->EdgeOnWeight << "\n";
}

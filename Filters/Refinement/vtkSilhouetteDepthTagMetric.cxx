// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSilhouetteDepthTagMetric.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementView.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceEdges.h"
#include "vtkWorldView.h"

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

constexpr double NarrowestContour = 0.001;
}

struct vtkSilhouetteDepthTagMetric::vtkInternals
{
  relevo::SurfaceEdges Edges;
  relevo::Eye Eye;

  void TagByNormals(
    vtkPolyData* mesh, const relevo::Placement& placement, int maximumLevel, vtkFloatArray* tags)
  {
    const relevo::SurfaceTriangles& surface = this->Edges.GetTriangles();
    const std::vector<dvec3> points = placement.GetPoints(surface);
    const std::vector<dvec3> areaVectors = relevo::ComputeAreaVectors(surface, points);
    vtkDataArray* normals = mesh->GetPointData()->GetNormals();
    if (normals && normals->GetNumberOfTuples() != surface.GetNumberOfPoints())
    {
      normals = nullptr;
    }
    const auto normalAt = [&](vtkIdType point)
    {
      dvec3 normal(0.0);
      if (normals)
      {
        normals->GetTuple(point, &normal[0]);
        normal = relevo::UnitOrZero(placement.GetNormal(normal));
      }
      if (normal == dvec3(0.0))
      {
        surface.ForEachTriangleIndex(
          surface.GetPlace(point), [&](vtkIdType t) { normal += areaVectors[t]; });
        normal = relevo::UnitOrZero(normal);
      }
      return normal;
    };

    tags->SetNumberOfComponents(1);
    tags->SetNumberOfTuples(surface.GetNumberOfPoints());
    vtkSMPTools::For(0, surface.GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          const dvec3 normal = normalAt(point);
          const double cosine = glm::dot(normal, this->Eye.GetDirectionFrom(points[point]));
          const bool known =
            normal != dvec3(0.0) && std::isfinite(glm::dot(points[point], dvec3(1.0)));
          tags->SetValue(point,
            known ? relevo::silhouetteLevel(static_cast<float>(cosine), maximumLevel) : 0.0f);
        }
      });
    tags->Modified();
  }

  void TagByContour(
    const relevo::Placement& placement, float width, int maximumLevel, vtkFloatArray* tags)
  {
    const relevo::SurfaceTriangles& surface = this->Edges.GetTriangles();
    const std::vector<dvec3> points = placement.GetPoints(surface);
    const std::vector<dvec3> areaVectors = relevo::ComputeAreaVectors(surface, points);
    const auto levelOf = [&](vtkIdType i)
    {
      const relevo::SurfaceEdge& edge = this->Edges.GetEdges()[i];
      if (edge.Type == relevo::SurfaceEdge::OPEN)
      {
        return static_cast<float>(maximumLevel);
      }
      const dvec3 middle = 0.5 * (points[edge.Points[0]] + points[edge.Points[1]]);
      const dvec3 toEye = this->Eye.GetDirectionFrom(middle);
      const auto cosineOf = [&](vtkIdType t)
      { return static_cast<float>(glm::dot(relevo::UnitOrZero(areaVectors[t]), toEye)); };
      const float sign = edge.Type == relevo::SurfaceEdge::FLIPPED ? -1.0f : 1.0f;
      return relevo::contourLevel(
        cosineOf(edge.Triangles[0]), sign * cosineOf(edge.Triangles[1]), width, maximumLevel);
    };
    this->Edges.TagPoints(tags, levelOf);
  }
};

vtkStandardNewMacro(vtkSilhouetteDepthTagMetric);

vtkSilhouetteDepthTagMetric::vtkSilhouetteDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkSilhouetteDepthTagMetric::~vtkSilhouetteDepthTagMetric() = default;

void vtkSilhouetteDepthTagMetric::SetCriterion(int criterion)
{
  if (criterion != NORMAL_ANGLE && criterion != CONTOUR)
  {
    vtkErrorMacro("Criterion " << criterion << " is neither NORMAL_ANGLE (0) nor CONTOUR (1).");
    return;
  }
  if (this->Criterion != criterion)
  {
    this->Criterion = criterion;
    this->Modified();
  }
}

const char* vtkSilhouetteDepthTagMetric::GetCriterionAsString()
{
  return this->Criterion == CONTOUR ? "Contour" : "NormalAngle";
}

void vtkSilhouetteDepthTagMetric::SetContourWidth(double width)
{
  if (!(width >= NarrowestContour && width <= 1.0))
  {
    vtkErrorMacro(
      "ContourWidth " << width << " is no cosine from " << NarrowestContour << " to 1.");
    return;
  }
  if (this->ContourWidth != width)
  {
    this->ContourWidth = width;
    this->Modified();
  }
}

bool vtkSilhouetteDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  std::string error;
  if (!this->Internals->Eye.Set(view, error))
  {
    vtkErrorMacro(<< error << ".");
    return false;
  }
  this->Internals->Edges.Update(mesh);
  const relevo::Placement placement(view);
  if (this->Criterion == CONTOUR)
  {
    const float width = static_cast<float>(this->ContourWidth);
    this->Internals->TagByContour(placement, width, maximumLevel, tags);
  }
  else
  {
    this->Internals->TagByNormals(mesh, placement, maximumLevel, tags);
  }
  return true;
}

void vtkSilhouetteDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Criterion: " << this->GetCriterionAsString() << "\n";
  os << indent << "ContourWidth: " << this->ContourWidth << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSilhouetteDepthTagMetric.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementView.h"
#include "vtkSMPTools.h"
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

constexpr double NarrowestContour = 0.001;

// How a place is seen by its normals; with split normals there are several.
struct Facing
{
  float Cosine = 1.0f; // the least, without its sign
  bool Toward = false;
  bool Away = false;

  void Add(float cosine)
  {
    this->Cosine = std::min(this->Cosine, std::abs(cosine)); // 1 stays where there is no normal
    this->Toward = this->Toward || cosine > 0.0f;
    this->Away = this->Away || cosine < 0.0f;
  }
  void Add(const Facing& other)
  {
    this->Cosine = std::min(this->Cosine, other.Cosine);
    this->Toward = this->Toward || other.Toward;
    this->Away = this->Away || other.Away;
  }
  float GetLevel(int maximumLevel) const
  {
    return relevo::silhouetteLevel(this->Toward && this->Away ? 0.0f : this->Cosine, maximumLevel);
  }
};
}

struct vtkSilhouetteDepthTagMetric::vtkInternals
{
  relevo::SurfaceEdges Edges;
  relevo::Eye Eye;

  // Of every point, between its normal and the view; NaN where there is no normal.
  std::vector<float> ComputeCosines(vtkPolyData* mesh, const relevo::Placement& placement,
    const relevo::SurfaceTriangles& surface) const
  {
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

    std::vector<float> cosines(surface.GetNumberOfPoints(), std::nanf(""));
    vtkSMPTools::For(0, surface.GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          const dvec3 normal = normalAt(point);
          if (normal != dvec3(0.0) && std::isfinite(glm::dot(points[point], dvec3(1.0))))
          {
            cosines[point] =
              static_cast<float>(glm::dot(normal, this->Eye.GetDirectionFrom(points[point])));
          }
        }
      });
    return cosines;
  }

  static void TagEdgesByNormals(const std::vector<float>& cosines,
    const relevo::SurfaceEdges& edges, int maximumLevel, vtkFloatArray* tags)
  {
    std::vector<Facing> facings(cosines.size()); // of places
    for (std::size_t point = 0; point < cosines.size(); ++point)
    {
      facings[edges.GetTriangles().GetPlace(static_cast<vtkIdType>(point))].Add(cosines[point]);
    }
    relevo::TagEdges(edges, tags,
      [&](int edge)
      {
        Facing facing = facings[edges.GetEdges()[edge].Places[0]];
        facing.Add(facings[edges.GetEdges()[edge].Places[1]]);
        return facing.GetLevel(maximumLevel);
      });
  }

  void TagEdgesByContour(const relevo::Placement& placement, const relevo::SurfaceEdges& edges,
    float width, int maximumLevel, vtkFloatArray* tags) const
  {
    const relevo::SurfaceTriangles& surface = edges.GetTriangles();
    const std::vector<dvec3> points = placement.GetPoints(surface);
    const std::vector<dvec3> areaVectors = relevo::ComputeAreaVectors(surface, points);
    relevo::TagEdges(edges, tags,
      [&](int edge)
      {
        const int* places = edges.GetEdges()[edge].Places;
        const dvec3 middle = 0.5 * (points[places[0]] + points[places[1]]);
        const dvec3 toEye = this->Eye.GetDirectionFrom(middle);
        const auto cosineOf = [&](int t)
        { return static_cast<float>(glm::dot(relevo::UnitOrZero(areaVectors[t]), toEye)); };
        float level = 0.0f;
        edges.ForEachSides(edge,
          [&](int i)
          {
            const relevo::SurfaceEdgeSides& sides = edges.GetSides()[i];
            if (sides.Type == relevo::SurfaceEdgeSides::OPEN)
            {
              level = static_cast<float>(maximumLevel);
              return;
            }
            const float sign = sides.Type == relevo::SurfaceEdgeSides::FLIPPED ? -1.0f : 1.0f;
            level = relevo::contourLevel(cosineOf(sides.Triangles[0]),
              sign * cosineOf(sides.Triangles[1]), width, maximumLevel);
          });
        return level;
      });
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

bool vtkSilhouetteDepthTagMetric::SetEye(const vtkRefinementView& view)
{
  std::string error;
  if (!this->Internals->Eye.Set(view, error))
  {
    vtkErrorMacro(<< error << ".");
    return false;
  }
  return true;
}

bool vtkSilhouetteDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->SetEye(view))
  {
    return false;
  }
  relevo::SurfaceEdges& edges = this->Internals->Edges;
  edges.Update(mesh);
  if (this->Criterion == CONTOUR)
  {
    vtkNew<vtkFloatArray> edgeTags;
    this->ComputeEdgeTags(mesh, view, maximumLevel, edges, edgeTags);
    edges.TagPoints(edgeTags->GetPointer(0), tags);
    return true;
  }
  const std::vector<float> cosines =
    this->Internals->ComputeCosines(mesh, relevo::Placement(view), edges.GetTriangles());
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(static_cast<vtkIdType>(cosines.size()));
  for (std::size_t point = 0; point < cosines.size(); ++point)
  {
    Facing facing;
    facing.Add(cosines[point]);
    tags->SetValue(static_cast<vtkIdType>(point), facing.GetLevel(maximumLevel));
  }
  tags->Modified();
  return true;
}

bool vtkSilhouetteDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh, const vtkRefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags)
{
  if (!this->SetEye(view))
  {
    return false;
  }
  const relevo::Placement placement(view);
  if (this->Criterion == CONTOUR)
  {
    this->Internals->TagEdgesByContour(
      placement, edges, static_cast<float>(this->ContourWidth), maximumLevel, tags);
  }
  else
  {
    vtkInternals::TagEdgesByNormals(
      this->Internals->ComputeCosines(mesh, placement, edges.GetTriangles()), edges, maximumLevel,
      tags);
  }
  return true;
}

void vtkSilhouetteDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Criterion: " << this->GetCriterionAsString() << "\n";
  os << indent << "ContourWidth: " << this->ContourWidth << "\n";
}

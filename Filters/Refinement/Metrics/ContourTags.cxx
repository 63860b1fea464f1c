// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/ContourTags.h"

#include "Levels/LevelFunctions.h"
#include "Metrics/FunctionEvaluator.h"
#include "View/WorldView.h"

#include <algorithm>

namespace relevo
{
namespace
{
struct ContourFunctions : MetricParameters
{
  using MetricParameters::MetricParameters;
#include "glsl/Metrics/relevoMetricView.glsl"

  bool IsParallel() const
  {
    return this->metricParameters[1].w > 0.0f;
  }
};
}

bool ContourTags::TagPoints(
  MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->TagEdges(evaluator, view, maximumLevel, this->EdgeTags))
  {
    return false;
  }
  evaluator.GetMesh().GetEdges()->TagPoints(this->EdgeTags->GetPointer(0), tags);
  return true;
}

bool ContourTags::TagEdges(
  MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  MetricMesh& mesh = evaluator.GetMesh();
  if (!evaluator.GetShader(view, maximumLevel, GetShape(mesh).GetPoints().Origin, this->Shader))
  {
    return false;
  }
  this->UpdateNormals(mesh, view);
  this->ComputeOffsets(mesh);
  this->ComputeHeights(mesh);
  this->MeasureEdges(*mesh.GetEdges(), tags);
  const float width = this->Shader.Parameters[4 * 9];
  float* values = tags->GetPointer(0);
  vtkSMPTools::For(0, tags->GetNumberOfValues(),
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType edge = begin; edge < end; ++edge)
      {
        values[edge] = contourLevel(values[edge], width, maximumLevel);
      }
    });
  return true;
}

void ContourTags::MeasureEdges(const SurfaceEdges& edges, vtkFloatArray* measures) const
{
  ContourFunctions functions(this->Shader);
  const bool parallel = functions.IsParallel();
  const vec3* offsets = this->Offsets.data();
  const float* heights = this->Heights.data();
  relevo::TagEdges(edges, measures,
    [=, &edges](int edge) mutable
    {
      float squaredDistance = 1.0f; // heights are already cosines
      if (!parallel)
      {
        const int* mergedPoints = edges.GetEdges()[edge].MergedPoints;
        const vec3 middle = 0.5f * (offsets[mergedPoints[0]] + offsets[mergedPoints[1]]);
        squaredDistance = functions.metricDot(middle, middle);
      }
      float least = 1.0f;
      edges.ForEachSides(edge,
        [&](int i)
        {
          const SurfaceEdgeSides& sides = edges.GetSides()[i];
          const float height = heights[sides.Triangles[0]];
          const float other = sides.Type == SurfaceEdgeSides::OPEN ? 0.0f
            : sides.Type == SurfaceEdgeSides::FLIPPED              ? -heights[sides.Triangles[1]]
                                                                   : heights[sides.Triangles[1]];
          least = std::min(least, contourMeasure(height, other, squaredDistance));
        });
      return least;
    });
}

void ContourTags::UpdateNormals(MetricMesh& mesh, const RefinementView& view)
{
  const Placement placement(view);
  Dependencies dependencies = Dependencies::On(mesh.GetTime());
  const double* matrix = &placement.NormalToWorld[0][0];
  std::for_each(matrix, matrix + 9, [&](double value) { dependencies.Add(value); });
  if (!this->NormalDependencies.Update(dependencies))
  {
    return;
  }
  const std::vector<dvec3>& areaVectors = GetShape(mesh).GetNormals().GetAreaVectors();
  this->Normals.resize(areaVectors.size());
  this->Heights.resize(areaVectors.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(areaVectors.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        this->Normals[t] = vec3(UnitOrZero(placement.GetNormal(areaVectors[t])));
      }
    });
}

void ContourTags::ComputeOffsets(MetricMesh& mesh)
{
  const LocalPoints& points = GetShape(mesh).GetPoints();
  const float* x = points.Coordinates.data();
  this->Offsets.resize(static_cast<std::size_t>(points.GetNumberOfPoints()));
  vtkSMPTools::For(0, points.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      ContourFunctions functions(this->Shader);
      for (vtkIdType point = begin; point < end; ++point)
      {
        const float* p = x + 3 * point;
        this->Offsets[point] = functions.metricFromEye(vec3(p[0], p[1], p[2]));
      }
    });
}

void ContourTags::ComputeHeights(MetricMesh& mesh)
{
  const auto& triangles = mesh.GetTriangles()->GetTriangles();
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      ContourFunctions functions(this->Shader);
      const bool parallel = functions.IsParallel();
      const vec3 backwards = functions.metricXYZ(functions.metricParameters[5]);
      for (vtkIdType t = begin; t < end; ++t)
      {
        const vec3 toEye = parallel ? backwards : -this->Offsets[triangles[t][0]];
        this->Heights[t] = functions.metricDot(this->Normals[t], toEye);
      }
    });
}
}

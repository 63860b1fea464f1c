// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthTagMetric.h"

#include "Core/PointPlaces.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricShader.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"

vtkDepthTagMetric::vtkDepthTagMetric() = default;
vtkDepthTagMetric::~vtkDepthTagMetric() = default;

bool vtkDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh, const relevo::RefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags)
{
  vtkNew<vtkFloatArray> pointTags;
  if (!this->ComputeTags(mesh, view, maximumLevel, pointTags))
  {
    return false;
  }
  float* ofPoints = pointTags->GetPointer(0);
  relevo::UniteTags(edges.GetTriangles().GetPlaces(), ofPoints);
  relevo::TagEdges(edges, tags,
    [&](int edge)
    {
      const int* places = edges.GetEdges()[edge].Places;
      return 0.5f * (ofPoints[places[0]] + ofPoints[places[1]]);
    });
  return true;
}

bool vtkDepthTagMetric::GetShader(
  vtkPolyData*, const relevo::RefinementView&, int, const double[3], relevo::MetricShader& shader)
{
  shader.Source = nullptr;
  return true;
}

void vtkDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

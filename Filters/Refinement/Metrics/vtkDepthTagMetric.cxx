// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthTagMetric.h"

#include "Metrics/DepthTags.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MetricShader.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

vtkDepthTagMetric::vtkDepthTagMetric() = default;
vtkDepthTagMetric::~vtkDepthTagMetric() = default;

bool vtkDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (const auto evaluator = this->NewEvaluator(std::make_shared<relevo::MetricMesh>(mesh)))
  {
    return evaluator->ComputeTags(view, maximumLevel, tags);
  }
  vtkErrorMacro("This metric computes no tags: override ComputeTags() or NewEvaluator().");
  return false;
}

bool vtkDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh, const relevo::RefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags)
{
  if (const auto evaluator = this->NewEvaluator(std::make_shared<relevo::MetricMesh>(mesh)))
  {
    return evaluator->ComputeEdgeTags(view, maximumLevel, tags);
  }
  vtkNew<vtkFloatArray> pointTags;
  if (!this->ComputeTags(mesh, view, maximumLevel, pointTags))
  {
    return false;
  }
  return relevo::TagEdgesByPoints(this, edges, pointTags, tags);
}

bool vtkDepthTagMetric::GetShader(vtkPolyData* mesh, const relevo::RefinementView& view,
  int maximumLevel, const double origin[3], relevo::MetricShader& shader)
{
  if (const auto evaluator = this->NewEvaluator(std::make_shared<relevo::MetricMesh>(mesh)))
  {
    return evaluator->GetShader(view, maximumLevel, origin, shader);
  }
  shader.Source.clear();
  return true;
}

std::unique_ptr<relevo::MetricEvaluator> vtkDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>&)
{
  return nullptr;
}

void vtkDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MetricEvaluator.h"

#include "Core/PointPlaces.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MetricShader.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <utility>

namespace relevo
{
namespace
{
// Of a metric that keeps nothing.
class PlainEvaluator : public MetricEvaluator
{
public:
  PlainEvaluator(vtkDepthTagMetric* metric, const std::shared_ptr<MetricMesh>& mesh)
    : MetricEvaluator(mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->Metric->ComputeTags(this->GetMesh().GetPolyData(), view, maximumLevel, tags);
  }

  bool ComputeEdgeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    MetricMesh& mesh = this->GetMesh();
    return this->Metric->ComputeEdgeTags(
      mesh.GetPolyData(), view, maximumLevel, *mesh.GetEdges(), tags);
  }

  bool GetShader(const RefinementView& view, int maximumLevel, const double origin[3],
    MetricShader& shader) override
  {
    return this->Metric->GetShader(
      this->GetMesh().GetPolyData(), view, maximumLevel, origin, shader);
  }

private:
  vtkSmartPointer<vtkDepthTagMetric> Metric;
};
}

MetricEvaluator::MetricEvaluator(std::shared_ptr<MetricMesh> mesh)
  : Mesh(std::move(mesh))
{
}

MetricEvaluator::~MetricEvaluator() = default;

bool MetricEvaluator::ComputeEdgeTags(
  const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  vtkNew<vtkFloatArray> pointTags;
  if (!this->ComputeTags(view, maximumLevel, pointTags))
  {
    return false;
  }
  return TagEdgesByPoints(*this->Mesh->GetEdges(), pointTags, tags);
}

bool MetricEvaluator::GetShader(const RefinementView&, int, const double[3], MetricShader& shader)
{
  shader.Source = nullptr;
  return true;
}

std::unique_ptr<MetricEvaluator> MakeEvaluator(
  vtkDepthTagMetric* metric, const std::shared_ptr<MetricMesh>& mesh)
{
  std::unique_ptr<MetricEvaluator> evaluator = metric->NewEvaluator(mesh);
  if (!evaluator)
  {
    evaluator = std::make_unique<PlainEvaluator>(metric, mesh);
  }
  return evaluator;
}

bool TagEdgesByPoints(const SurfaceEdges& edges, vtkFloatArray* pointTags, vtkFloatArray* tags)
{
  if (pointTags->GetNumberOfValues() != edges.GetTriangles().GetNumberOfPoints())
  {
    return false;
  }
  float* ofPoints = pointTags->GetPointer(0);
  UniteTags(edges.GetTriangles().GetPlaces(), ofPoints);
  TagEdges(edges, tags,
    [&](int edge)
    {
      const int* places = edges.GetEdges()[edge].Places;
      return 0.5f * (ofPoints[places[0]] + ofPoints[places[1]]);
    });
  return true;
}
}

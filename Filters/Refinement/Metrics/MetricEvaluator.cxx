// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MetricEvaluator.h"

#include "Metrics/DepthTags.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MetricShader.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Parallel/PieceReduction.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <utility>

namespace relevo
{
namespace
{
// The evaluator of a metric that caches nothing.
class PlainEvaluator : public MetricEvaluator
{
public:
  PlainEvaluator(vtkDepthTagMetric* metric, const std::shared_ptr<MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
  {
  }

  bool ComputeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->GetMetric()->ComputeTags(this->GetMesh().GetPolyData(), view, maximumLevel, tags);
  }

  bool ComputeEdgeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    MetricMesh& mesh = this->GetMesh();
    return this->GetMetric()->ComputeEdgeTags(
      mesh.GetPolyData(), view, maximumLevel, *mesh.GetEdges(), tags);
  }

  bool GetShader(const RefinementView& view, int maximumLevel, const double origin[3],
    MetricShader& shader) override
  {
    return this->GetMetric()->GetShader(
      this->GetMesh().GetPolyData(), view, maximumLevel, origin, shader);
  }
};
}

MetricEvaluator::MetricEvaluator(vtkDepthTagMetric* metric, std::shared_ptr<MetricMesh> mesh)
  : Metric(metric)
  , Mesh(std::move(mesh))
{
}

MetricEvaluator::~MetricEvaluator() = default;

bool MetricEvaluator::ComputeEdgeTags(
  const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  vtkNew<vtkFloatArray> pointTags;
  return this->ComputeTags(view, maximumLevel, pointTags) &&
    TagEdgesByPoints(this->Metric, *this->Mesh->GetEdges(), pointTags, tags);
}

bool MetricEvaluator::GetShader(const RefinementView&, int, const double[3], MetricShader& shader)
{
  shader.Source.clear();
  return true;
}

void MetricEvaluator::ShareNumbers(
  const RefinementView& view, const PieceReduction& pieces, GlobalSurfaceInfo& whole)
{
  whole.Numbers[this->Metric] = this->ComputeNumbers(view, pieces);
}

std::vector<double> MetricEvaluator::ComputeNumbers(const RefinementView&, const PieceReduction&)
{
  return {};
}

std::vector<double> MetricEvaluator::GetNumbers(const RefinementView& view)
{
  if (const GlobalSurfaceInfo* whole = this->Mesh->GetWhole())
  {
    const auto shared = whole->Numbers.find(this->Metric);
    if (shared != whole->Numbers.end() && !shared->second.empty())
    {
      return shared->second;
    }
  }
  return this->ComputeNumbers(view, PieceReduction());
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
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ReliefMetric.h"

#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "vtkObjectFactory.h"

#include <algorithm>

namespace
{
// Computes tags for the displaced mesh, which has the same points and edges in the same order.
class ReliefEvaluator : public relevo::MetricEvaluator
{
public:
  ReliefEvaluator(ReliefMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
    , Relief(std::make_shared<relevo::MetricMesh>())
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->Update().ComputeTags(view, maximumLevel, tags);
  }

  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->Update().ComputeEdgeTags(view, maximumLevel, tags);
  }

private:
  // The metric's evaluator for the displaced mesh.
  relevo::MetricEvaluator& Update()
  {
    this->Relief->Update(this->Metric->GetRelief());
    vtkDepthTagMetric* metric = this->Metric->GetMetric();
    if (!this->Evaluator || this->Evaluator->GetMetric() != metric)
    {
      this->Evaluator = relevo::MakeEvaluator(metric, this->Relief);
    }
    return *this->Evaluator;
  }

  vtkSmartPointer<ReliefMetric> Metric;
  std::shared_ptr<relevo::MetricMesh> Relief;
  std::unique_ptr<relevo::MetricEvaluator> Evaluator;
};
}

vtkStandardNewMacro(ReliefMetric);

void ReliefMetric::SetMetric(vtkDepthTagMetric* metric)
{
  this->Metric = metric;
  this->Modified();
}

void ReliefMetric::SetRelief(vtkPolyData* relief)
{
  this->Relief = relief;
  this->Modified();
}

std::unique_ptr<relevo::MetricEvaluator> ReliefMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<ReliefEvaluator>(this, mesh);
}

vtkMTimeType ReliefMetric::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Metric ? this->Metric->GetMTime() : 0,
    this->Relief ? this->Relief->GetMTime() : 0 });
}

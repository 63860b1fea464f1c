// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightErrorDepthTagMetric.h"

#include "Metrics/DisplacedSurface.h"
#include "Metrics/FaceErrorEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "View/RefinementView.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <string>

namespace
{
class HeightErrorEvaluator : public relevo::FaceErrorEvaluator
{
public:
  HeightErrorEvaluator(
    vtkHeightErrorDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FaceErrorEvaluator(metric, mesh)
  {
  }

protected:
  std::string FindError(const relevo::RefinementView& view) const override
  {
    return view.Displaced
      ? ""
      : "There is no height map to measure: set a vtkDisplacement with a height "
        "map for the vtkAdaptiveRefinement";
  }

  void AddTo(const relevo::RefinementView& view, relevo::Dependencies& now) const override
  {
    view.Displaced->AddTo(now);
  }

  int GetHighestLevel(const relevo::RefinementView& view, int) const override
  {
    return view.Displaced->GetMaximumLevel();
  }

  std::unique_ptr<relevo::DisplacedFaces> MakeFaces(const relevo::RefinementView& view,
    const std::shared_ptr<const relevo::PatternFamily>& patterns, int, std::string&) override
  {
    return view.Displaced->MakeFaces(
      this->GetMesh().GetPolyData(), this->GetMesh().GetWhole(), patterns);
  }
};
}

vtkStandardNewMacro(vtkHeightErrorDepthTagMetric);

vtkHeightErrorDepthTagMetric::vtkHeightErrorDepthTagMetric() = default;
vtkHeightErrorDepthTagMetric::~vtkHeightErrorDepthTagMetric() = default;

std::unique_ptr<relevo::MetricEvaluator> vtkHeightErrorDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<HeightErrorEvaluator>(this, mesh);
}

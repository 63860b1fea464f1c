// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/PointTags.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternSelection.h"
#include "Metrics/DepthTags.h"
#include "Metrics/MetricCache.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAbstractArray.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDataSet.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"

namespace relevo
{
PointTags::PointTags()
  : Source(new MetricCache)
{
}

PointTags::~PointTags() = default;

void PointTags::Reset()
{
  this->Source->Clear();
}

const float* PointTags::GetValues() const
{
  return this->Values->GetPointer(0);
}

bool PointTags::Compute(vtkAdaptiveRefinement* recipe, vtkDataSet* input, const GetMesh& getMesh,
  const RefinementView& view, std::string& error)
{
  std::string reason;
  this->Kind = UNIFORM;
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  if (!metric)
  {
    this->Source->Clear();
  }
  if (vtkAbstractArray* array = FindDepthTagArray(recipe, input))
  {
    this->Values->SetNumberOfComponents(1);
    this->Values->SetNumberOfTuples(input->GetNumberOfPoints());
    if (!TakeDepthTags(array, input->GetNumberOfPoints(), this->Values->GetPointer(0), reason))
    {
      error = MakeError(reason);
      return false;
    }
    this->Kind = OF_ARRAY;
  }
  else if (metric)
  {
    RefinementView viewOfSteps = view;
    viewOfSteps.Patterns = GetRoundedPatternFamily(recipe);
    if (!ComputeDepthTags(this->Source->GetEvaluator(metric, getMesh()), viewOfSteps,
          GetHighestTag(recipe, false), false, this->Values, reason))
    {
      error = MakeError(reason);
      return false;
    }
    this->Kind = OF_METRIC;
  }
  return true;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveTags.h"

#include "Curves/CurveMesh.h"
#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/RefinementPreparation.h"
#include "Mathematics/RefinementMathematics.h"
#include "Metrics/DepthTags.h"
#include "Metrics/EdgeLevels.h"
#include "Metrics/MetricCache.h"
#include "Patterns/SegmentSteps.h"
#include "View/RefinementView.h"
#include "vtkAbstractArray.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Gives each curve getTag(curve), in parallel.
template <typename GetTag>
void SetTags(const CurveMesh& mesh, std::vector<float>& tags, const GetTag& getTag)
{
  tags.resize(mesh.GetCurves().size());
  vtkSMPTools::For(0, mesh.GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        tags[c] = getTag(mesh.GetCurves()[c]);
      }
    });
}
}

CurveTags::CurveTags()
  : Source(new MetricCache)
{
}

CurveTags::~CurveTags() = default;

void CurveTags::Reset()
{
  this->Polygons = nullptr;
  this->Source->Clear();
}

bool CurveTags::Compute(vtkAdaptiveRefinement* recipe, vtkPointSet* input, const CurveMesh& mesh,
  const RefinementView& view, std::string& error)
{
  std::string obstacle;
  if (!this->ComputeTags(recipe, input, mesh, view, obstacle))
  {
    error = MakeError(obstacle);
    return false;
  }
  this->ChooseSegments(recipe);
  return true;
}

bool CurveTags::ComputeTags(vtkAdaptiveRefinement* recipe, vtkPointSet* input,
  const CurveMesh& mesh, const RefinementView& view, std::string& error)
{
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  if (!metric)
  {
    this->Reset();
  }
  if (vtkAbstractArray* array = FindDepthTagArray(recipe, input))
  {
    this->PointTags->SetNumberOfComponents(1);
    this->PointTags->SetNumberOfTuples(input->GetNumberOfPoints());
    float* tags = this->PointTags->GetPointer(0);
    if (!TakeDepthTags(array, input->GetNumberOfPoints(), tags, error))
    {
      return false;
    }
    SetTags(mesh, this->Tags,
      [&, nodes = mesh.GetNodes().data()](const CurveMesh::Curve& curve) {
        return meanTag(tags[nodes[curve.FirstPoint]], tags[nodes[curve.FirstPoint + curve.Degree]]);
      });
  }
  else if (metric)
  {
    if (!this->Polygons)
    {
      this->Polygons = mesh.NewControlPolygons();
    }
    RefinementView viewOfSteps = view;
    viewOfSteps.Patterns = GetRoundedPatternFamily(recipe);
    if (!ComputeDepthTags(this->Source->GetEvaluator(metric, this->Polygons), viewOfSteps,
          GetHighestTag(recipe, false), false, this->PointTags, error))
    {
      return false;
    }
    const float* tags = this->PointTags->GetPointer(0);
    SetTags(mesh, this->Tags,
      [=](const CurveMesh::Curve& curve)
      {
        const float* first = tags + curve.FirstPoint;
        return *std::max_element(first, first + curve.Degree + 1);
      });
  }
  else
  {
    const float highest = static_cast<float>(recipe->GetMaximumLevel());
    SetTags(mesh, this->Tags, [=](const CurveMesh::Curve&) { return highest; });
  }
  return true;
}

void CurveTags::ChooseSegments(vtkAdaptiveRefinement* recipe)
{
  const bool wholeNumbers = recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
  const SegmentSteps steps = SegmentSteps::Make(wholeNumbers);
  const float offset = static_cast<float>(recipe->GetLevelOffset());
  const int highest = recipe->GetMaximumLevel();
  this->Segments.resize(this->Tags.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Tags.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        float& tag = this->Tags[c];
        tag = clampTag(tag, offset, highest);
        this->Segments[c] =
          steps.GetSegments(wholeNumbers ? SegmentSteps::GetWholeNumberStep(tag) : levelOfTag(tag));
      }
    });
}
}

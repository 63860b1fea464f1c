// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/EdgeTags.h"

#include "Evaluation/SampledSurface.h"
#include "Mesh/FaceEdges.h"
#include "Mesh/RefinementMesh.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/DepthTags.h"
#include "Metrics/MetricCache.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Points/MergedPoints.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <utility>

namespace relevo
{
EdgeTags::EdgeTags()
  : EdgeTags(std::make_shared<MetricCache>())
{
}

EdgeTags::EdgeTags(std::shared_ptr<MetricCache> source)
  : Source(std::move(source))
{
}

EdgeTags::~EdgeTags() = default;

void EdgeTags::SetSource(std::shared_ptr<MetricCache> source)
{
  this->Source = std::move(source);
  this->Reset();
}

void EdgeTags::Reset()
{
  this->Edges.reset();
  this->FaceEdges.clear();
}

const float* EdgeTags::GetValues() const
{
  return this->Values->GetPointer(0);
}

vtkIdType EdgeTags::GetNumberOfValues() const
{
  return this->Kind == UNIFORM ? 0 : this->Values->GetNumberOfTuples();
}

bool EdgeTags::Compute(vtkAdaptiveRefinement* recipe, vtkPolyData* input,
  const RefinementMesh& mesh, const RefinementView& view, int highest, std::string& error)
{
  this->Kind = UNIFORM;
  this->Shader = MetricShader();
  if (vtkAbstractArray* array = FindDepthTagArray(recipe, input))
  {
    this->Values->SetNumberOfComponents(1);
    this->Values->SetNumberOfTuples(input->GetNumberOfPoints());
    if (!TakeDepthTags(array, input->GetNumberOfPoints(), this->Values->GetPointer(0), error))
    {
      return false;
    }
    this->Kind = PER_POINT;
  }
  else if (vtkDepthTagMetric* metric = recipe->GetMetric())
  {
    const bool perEdge = recipe->GetLevelRule() == vtkDepthTagMetric::PER_EDGE;
    MetricEvaluator& evaluator = this->Source->GetEvaluator(metric, input);
    if (perEdge)
    {
      this->BuildEdges(input, mesh);
    }
    RefinementView viewOfRecipe = view;
    viewOfRecipe.Patterns = GetPatternFamily(recipe, input);
    viewOfRecipe.Displaced = SampledSurface::Make(recipe);
    if (!ComputeDepthTags(evaluator, viewOfRecipe, highest, perEdge, this->Values, error))
    {
      return false;
    }
    this->Kind = perEdge ? PER_EDGE : PER_POINT;
  }
  if (!GetMetricInUse(recipe, input))
  {
    this->Source->Clear();
    this->Reset();
  }
  if (this->Kind == PER_POINT && !mesh.MergedPoints.empty())
  {
    UniteTags(mesh.MergedPoints, this->Values->GetPointer(0));
  }
  return true;
}

bool EdgeTags::ComputeOrDescribe(vtkAdaptiveRefinement* recipe, vtkPolyData* input,
  const RefinementMesh& mesh, const RefinementView& view, std::string& error)
{
  this->Shader = MetricShader();
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  if (metric &&
    !this->Source->GetEvaluator(metric, input)
       .GetShader(view, GetHighestTag(recipe, false), mesh.Origin, this->Shader))
  {
    error = GetNoTagsError(metric);
    return false;
  }
  if (this->Shader.Source.empty())
  {
    return this->Compute(recipe, input, mesh, view, error);
  }
  const bool perEdge = recipe->GetLevelRule() == vtkDepthTagMetric::PER_EDGE;
  this->Kind = perEdge ? PER_EDGE : PER_POINT;
  this->Values->Reset();
  if (perEdge || !this->Shader.TagsPoints)
  {
    this->BuildEdges(input, mesh);
  }
  return true;
}

void EdgeTags::BuildEdges(vtkPolyData* input, const RefinementMesh& mesh)
{
  const std::shared_ptr<const SurfaceEdges>& edges = this->Source->GetMesh(input).GetEdges();
  if (this->Edges == edges)
  {
    return;
  }
  this->Edges = edges;
  this->FaceEdges = FindFaceEdges(mesh, *edges);
}

bool EdgeTags::Compute(vtkAdaptiveRefinement* recipe, vtkPolyData* input,
  const RefinementMesh& mesh, const RefinementView& view, std::string& error)
{
  return this->Compute(recipe, input, mesh, view, GetHighestTag(recipe, false), error);
}
}

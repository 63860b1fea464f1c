// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picking/PickedLevels.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternChoice.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/RefinementPattern.h"
#include "Recipe/RecipeLevels.h"
#include "State/ViewSelection.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

namespace relevo
{
const PatternSelection* PickedLevels::Get(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  const RefinementMesh& mesh, vtkMTimeType meshTime, const ViewSelection& drawn, Kinds kind)
{
  const PatternSelection& selection = drawn.GetSelection();
  const bool isDrawn = drawn.GetLevelsTime() > meshTime &&
    selection.GetNumberOfFaces() == static_cast<int>(mesh.Faces.size());
  if (isDrawn &&
    (kind == Kinds::MORPHED || (kind == Kinds::ROUNDED && selection.GetMorphTags().empty())))
  {
    return &selection;
  }
  if (this->OwnDependencies.Update(Dependencies::On(
        meshTime, isDrawn, isDrawn ? drawn.GetLevelsTime() : recipe->GetMTime(), kind)))
  {
    this->Valid = isDrawn || this->SelectAnew(input, recipe, mesh, drawn);
    if (isDrawn)
    {
      this->Round(selection, recipe, mesh, kind == Kinds::HIGHEST);
    }
  }
  return this->Valid ? &this->Own : nullptr;
}

bool PickedLevels::SelectAnew(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  const RefinementMesh& mesh, const ViewSelection& drawn)
{
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  if (metric && metric->IsViewDependent())
  {
    this->Assign(recipe, mesh, [recipe](int, int) { return 1 << recipe->GetMaximumLevel(); });
    return true;
  }
  std::string error; // reported when the surface is drawn
  return SelectPatterns(
    input, recipe, RefinementView(), mesh, drawn.GetTags().GetSource(), this->Own, error);
}

void PickedLevels::Round(const PatternSelection& drawn, vtkAdaptiveRefinement* recipe,
  const RefinementMesh& mesh, bool toHighest)
{
  std::vector<int> segments(3 * mesh.Faces.size());
  for (size_t face = 0; face < mesh.Faces.size(); ++face)
  {
    drawn.GetFacePattern(static_cast<int>(face)).GetEdgeSegments(&segments[3 * face]);
  }
  if (toHighest && !segments.empty())
  {
    std::fill(
      segments.begin(), segments.end(), *std::max_element(segments.begin(), segments.end()));
  }
  this->Assign(recipe, mesh,
    [&segments](int face, int edge) { return segments[3 * static_cast<size_t>(face) + edge]; });
}

template <typename GetSegments>
void PickedLevels::Assign(
  vtkAdaptiveRefinement* recipe, const RefinementMesh& mesh, const GetSegments& getSegments)
{
  const auto family = GetRoundedPatternFamily(recipe);
  const SegmentSteps& steps = family->GetSegmentSteps();
  std::vector<unsigned int> entries;
  entries.reserve(mesh.Faces.size());
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const int face = static_cast<int>(f);
    const auto step = [&](int edge) { return steps.FindStep(getSegments(face, edge)); };
    entries.push_back(family->GetEntry(mesh.Faces[f].Order, step(0), step(1), step(2)));
  }
  this->Own.Assign(*family, std::move(entries), {});
}
}

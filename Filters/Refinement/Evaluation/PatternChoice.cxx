// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/PatternChoice.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternSelection.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"

namespace relevo
{
bool SelectPatterns(vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view,
  const RefinementMesh& mesh, const std::shared_ptr<MetricCache>& source,
  PatternSelection& selection, std::string& error)
{
  EdgeTags tags(source);
  std::string reason;
  if (!tags.Compute(recipe, input, mesh, view, reason))
  {
    error = MakeError(reason);
    return false;
  }
  selection.Select(mesh, tags, *GetPatternFamily(recipe, input), recipe->GetMaximumLevel(),
    static_cast<float>(recipe->GetLevelOffset()));
  return true;
}
}

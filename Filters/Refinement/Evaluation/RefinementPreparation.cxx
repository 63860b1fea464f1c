// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/RefinementPreparation.h"

#include "Core/RefinementView.h"
#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Surfaces/FloatRange.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"

namespace relevo
{
bool BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe, bool keepNormals,
  RefinementMesh& mesh, std::string& error, std::string& warning)
{
  if (!recipe)
  {
    error = "No recipe: call SetRefinement() with a vtkAdaptiveRefinement.";
    return false;
  }
  if (recipe->GetDisplacement() && !recipe->GetDisplacement()->Update())
  {
    error = "The displacement's height map could not be read.";
    return false;
  }
  if (!mesh.Build(input, recipe->GetSurface(), recipe->GetDisplacement(), keepNormals))
  {
    error = "Cannot refine the input: " + mesh.GetError() + ".";
    return false;
  }
  if (mesh.GetNumberOfDroppedTriangles() > 0)
  {
    warning = std::to_string(mesh.GetNumberOfDroppedTriangles()) +
      " degenerate cells or triangles dropped (two corners at one place, fewer than three points, "
      "or non-finite coordinates).";
  }
  return true;
}

std::string FindObstacle(vtkAdaptiveRefinement* recipe)
{
  const std::string excess = FindExcess(recipe->GetSurface(), recipe->GetDisplacement());
  const std::string obstacle = excess.empty() ? FindPatternObstacle(recipe) : excess + ".";
  return obstacle.empty() ? "" : "Cannot refine the input: " + obstacle;
}

bool PrepareMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe, RefinementMesh& mesh,
  std::string& error, std::string& warning)
{
  if (recipe && input->GetNumberOfCells() == 0)
  {
    error = "The input has no cells: there is nothing to refine.";
    return false;
  }
  if (!BuildMesh(input, recipe, true, mesh, error, warning))
  {
    return false;
  }
  error = FindObstacle(recipe);
  if (error.empty() && recipe->GetSurface())
  {
    const std::string lack = recipe->GetSurface()->GetEvaluationError();
    error = lack.empty() ? "" : "Cannot refine the input: " + lack + ".";
  }
  return error.empty();
}

bool SelectPatterns(vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view,
  const RefinementMesh& mesh, const std::shared_ptr<TagSource>& source, PatternSelection& selection,
  std::string& error)
{
  EdgeTags tags(source);
  std::string problem;
  if (!tags.Compute(recipe, input, mesh, view, problem))
  {
    error = "Cannot refine the input: " + problem + ".";
    return false;
  }
  selection.Select(mesh, tags, *GetPatternFamily(recipe, input), recipe->GetMaximumLevel(),
    static_cast<float>(recipe->GetLevelOffset()));
  return true;
}
}

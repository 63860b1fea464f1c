// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/MeshPreparation.h"

#include "Mesh/RefinementMesh.h"
#include "Recipe/RecipeLevels.h"
#include "Surfaces/FloatRange.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"

#include <utility>

namespace relevo
{
namespace
{
bool ReadHeights(vtkAdaptiveRefinement* recipe, std::string& error)
{
  if (!recipe)
  {
    error = "There is no recipe: call SetRefinement() with a vtkAdaptiveRefinement.";
    return false;
  }
  vtkDisplacement* displacement = recipe->GetDisplacement();
  if (displacement && !displacement->Update())
  {
    const std::string reason = displacement->GetHeightMap()->GetErrorMessage();
    error = "The displacement's height map could not be read" +
      (reason.empty() ? std::string(".") : ": " + reason);
    return false;
  }
  return true;
}

bool BuildFaces(vtkPolyData* input, vtkAdaptiveRefinement* recipe, bool keepNormals,
  const GlobalSurfaceInfo* whole, RefinementMesh& mesh, std::string& error, std::string& warning)
{
  if (!mesh.Build(input, recipe->GetSurface(), recipe->GetDisplacement(), keepNormals, whole))
  {
    error = MakeError(mesh.GetError());
    return false;
  }
  if (mesh.GetNumberOfDroppedTriangles() > 0)
  {
    warning = std::to_string(mesh.GetNumberOfDroppedTriangles()) +
      " degenerate cells or triangles are left out: they have coincident corners, fewer than "
      "three points, or coordinates that are not finite.";
  }
  return true;
}
}

bool BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe, bool keepNormals,
  const GlobalSurfaceInfo* whole, RefinementMesh& mesh, std::string& error, std::string& warning)
{
  return ReadHeights(recipe, error) &&
    BuildFaces(input, recipe, keepNormals, whole, mesh, error, warning);
}

std::string FindError(vtkAdaptiveRefinement* recipe)
{
  const std::string error = FindRangeError(recipe->GetSurface(), recipe->GetDisplacement());
  return error.empty() ? FindPatternError(recipe) : error;
}

std::string MakeError(const std::string& error)
{
  return error.empty() ? error : "Cannot refine the input: " + error + ".";
}

std::string FindNewWarning(vtkAdaptiveRefinement* recipe, std::string& last)
{
  const std::string warning = FindPatternWarning(recipe);
  return std::exchange(last, warning) == warning ? std::string() : warning;
}

bool PrepareMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe, const GlobalSurfaceInfo* whole,
  RefinementMesh& mesh, std::string& error, std::string& warning)
{
  if (recipe && !whole && input->GetNumberOfCells() == 0)
  {
    error = "The input has no cells: there is nothing to refine.";
    return false;
  }
  if (!ReadHeights(recipe, error))
  {
    return false;
  }
  std::string reason = FindError(recipe);
  if (reason.empty() && recipe->GetSurface())
  {
    reason = recipe->GetSurface()->GetEvaluationError();
  }
  error = MakeError(reason);
  return error.empty() && BuildFaces(input, recipe, true, whole, mesh, error, warning);
}
}

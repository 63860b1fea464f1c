// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementPreparation
 * @brief   what is needed to refine a mesh: checked, prepared, levels chosen
 *
 * The mapper asks BuildMesh() when the mesh or the recipe's parts have changed, and FindObstacle()
 * in every frame; the filter and the locator ask PrepareMesh() for both, and SelectPatterns().
 */
#ifndef RefinementPreparation_h
#define RefinementPreparation_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <memory> // for TagSource
#include <string> // for messages

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class PatternSelection;
class RefinementMesh;
class TagSource;

/**
 * Reads the displacement's height map and builds the mesh. False, with an error to show the user,
 * where that cannot be done. `keepNormals`: as RefinementMesh::Build() has it.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  bool keepNormals, RefinementMesh& mesh, std::string& error, std::string& warning);

/**
 * Why a mesh that is built cannot be refined with the recipe's settings as they are now: an error
 * to show the user, or empty.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindObstacle(vtkAdaptiveRefinement* recipe);

//@{
/**
 * Build the mesh and check the recipe; choose patterns, by tags from a source that the caller
 * keeps. False, with an error to show the user, when the recipe cannot be applied.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool PrepareMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  RefinementMesh& mesh, std::string& error, std::string& warning);
RELEVOFILTERSREFINEMENT_EXPORT bool SelectPatterns(vtkPolyData* input,
  vtkAdaptiveRefinement* recipe, const RefinementView& view, const RefinementMesh& mesh,
  const std::shared_ptr<TagSource>& source, PatternSelection& selection, std::string& error);
//@}
}

#endif

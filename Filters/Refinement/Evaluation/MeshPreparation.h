// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what is needed to refine a mesh: checked, prepared, levels chosen
 *
 * The mapper asks BuildMesh() when the mesh or the recipe's parts have changed, and FindError()
 * in every frame; the filter and the locator ask PrepareMesh() for both, and SelectPatterns().
 *
 * An obstacle is a clause that says why a mesh cannot be refined, here and in the functions called;
 * an error is what the user is shown.
 */
#ifndef MeshPreparation_h
#define MeshPreparation_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <string> // for messages

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
class RefinementMesh;
struct GlobalSurfaceInfo;

/**
 * Reads the displacement's height map and builds the mesh. False, with an error to show the user,
 * where that cannot be done. `keepNormals` and `whole`: as RefinementMesh::Build() has them.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  bool keepNormals, const GlobalSurfaceInfo* whole, RefinementMesh& mesh, std::string& error,
  std::string& warning);

/**
 * Why a mesh that is built cannot be refined with the recipe's settings as they are now; empty
 * where it can.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindError(vtkAdaptiveRefinement* recipe);

/// The error that an obstacle makes; empty for none.
RELEVOFILTERSREFINEMENT_EXPORT std::string MakeError(const std::string& reason);

/**
 * What the recipe asks for and does not get, as a warning to show the user. Empty for nothing, and
 * for what `last` says already; `last` becomes it.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindNewWarning(
  vtkAdaptiveRefinement* recipe, std::string& last);

/**
 * Build the mesh (a piece may have no cells) and check the recipe. False, with an error to show the
 * user, when the recipe cannot be applied.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool PrepareMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  const GlobalSurfaceInfo* whole, RefinementMesh& mesh, std::string& error, std::string& warning);
}

#endif

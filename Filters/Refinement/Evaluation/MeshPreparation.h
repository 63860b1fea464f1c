// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks and prepares a mesh for refinement
 *
 * The mapper calls BuildMesh() when the mesh or the parts of the recipe have changed, and
 * FindError() in each frame. The filter and the locator call PrepareMesh() for both, and
 * SelectPatterns().
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
 * Update the displacement's height map and build the mesh. Returns false and an error for the user
 * on failure. For `keepNormals` and `whole`, see RefinementMesh::Build().
 */
RELEVOFILTERSREFINEMENT_EXPORT bool BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  bool keepNormals, const GlobalSurfaceInfo* whole, RefinementMesh& mesh, std::string& error,
  std::string& warning);

/**
 * Return why a mesh that was built cannot be refined with the current settings of the recipe, or an
 * empty string if it can.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindError(vtkAdaptiveRefinement* recipe);

/// Convert a reason to an error; empty for none.
RELEVOFILTERSREFINEMENT_EXPORT std::string MakeError(const std::string& reason);

/**
 * Return a warning for the user about settings of the recipe that have no effect. Returns an empty
 * string if there are none or if the warning equals `last`. `last` is set to the current warning.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindNewWarning(
  vtkAdaptiveRefinement* recipe, std::string& last);

/**
 * Build the mesh and check the recipe. A piece may have no cells. Returns false and an error for
 * the user if the recipe cannot be applied.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool PrepareMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  const GlobalSurfaceInfo* whole, RefinementMesh& mesh, std::string& error, std::string& warning);
}

#endif

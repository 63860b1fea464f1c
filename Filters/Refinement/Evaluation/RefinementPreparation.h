// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementPreparation
 * @brief   what the CPU needs to refine a mesh: checked, prepared, levels chosen
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

//@{
/**
 * Build the mesh; choose its patterns, by tags from a source that the caller keeps. False, with an
 * error to show the user, when the recipe cannot be applied.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool PrepareMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  RefinementMesh& mesh, std::string& error, std::string& warning);
RELEVOFILTERSREFINEMENT_EXPORT bool SelectPatterns(vtkPolyData* input,
  vtkAdaptiveRefinement* recipe, const RefinementView& view, const RefinementMesh& mesh,
  const std::shared_ptr<TagSource>& source, PatternSelection& selection, std::string& error);
//@}
}

#endif

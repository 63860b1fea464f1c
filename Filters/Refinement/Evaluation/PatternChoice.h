// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the patterns of a mesh's faces by a recipe
 */
#ifndef PatternChoice_h
#define PatternChoice_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <memory> // for MetricCache
#include <string> // for errors

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class MetricCache;
class PatternSelection;
class RefinementMesh;

/**
 * Select patterns for the faces of a mesh that PrepareMesh() has built, by tags from a source that
 * the caller owns. False, with an error to show the user, when the recipe cannot be applied.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool SelectPatterns(vtkPolyData* input,
  vtkAdaptiveRefinement* recipe, const RefinementView& view, const RefinementMesh& mesh,
  const std::shared_ptr<MetricCache>& source, PatternSelection& selection, std::string& error);
}

#endif

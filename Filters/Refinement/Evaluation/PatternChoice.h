// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   selects the patterns of a mesh's faces according to a recipe
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
 * Select patterns for the faces of a mesh built by PrepareMesh(), from tags of a cache that the
 * caller owns. Returns false and an error for the user if the recipe cannot be applied.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool SelectPatterns(vtkPolyData* input,
  vtkAdaptiveRefinement* recipe, const RefinementView& view, const RefinementMesh& mesh,
  const std::shared_ptr<MetricCache>& source, PatternSelection& selection, std::string& error);
}

#endif

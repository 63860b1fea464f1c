// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   where the levels and the patterns of a recipe come from
 */
#ifndef RecipeLevels_h
#define RecipeLevels_h

#include "Patterns/PatternFamily.h"
#include "RelevoFiltersRefinementModule.h" // for export macro

#include <memory> // for families
#include <string> // for sentences

class vtkAbstractArray;
class vtkAdaptiveRefinement;
class vtkDataSet;
class vtkDepthTagMetric;
class vtkPolyData;

namespace relevo
{
/**
 * Why the recipe's pattern table lacks the patterns that the recipe needs, as a clause that says
 * what to do; empty if it has them.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindPatternError(vtkAdaptiveRefinement* recipe);

/**
 * What the recipe asks of its patterns that they do not give, though they refine, as sentences that
 * say what to do; empty for nothing.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindPatternWarning(vtkAdaptiveRefinement* recipe);

/**
 * The patterns that a recipe draws an input with; where there is an obstacle, others.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::shared_ptr<const PatternFamily> GetPatternFamily(
  vtkAdaptiveRefinement* recipe, vtkPolyData* input);

/**
 * The patterns that a recipe draws with where it does not morph.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::shared_ptr<const PatternFamily> GetRoundedPatternFamily(
  vtkAdaptiveRefinement* recipe);

/**
 * The level that a metric's tags are cut off at: MaximumLevel, but of an absolute metric more where
 * an offset, the recipe's or a budget's (`isMoved`), brings higher tags down.
 */
RELEVOFILTERSREFINEMENT_EXPORT int GetHighestTag(vtkAdaptiveRefinement* recipe, bool isMoved);

/**
 * The metric that gives the levels; nullptr where an array does, or nothing.
 */
RELEVOFILTERSREFINEMENT_EXPORT vtkDepthTagMetric* GetMetricInUse(
  vtkAdaptiveRefinement* recipe, vtkDataSet* input);

/// The array that gives the levels; nullptr where the input has none of that name.
RELEVOFILTERSREFINEMENT_EXPORT vtkAbstractArray* FindDepthTagArray(
  vtkAdaptiveRefinement* recipe, vtkDataSet* input);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   finds the source of levels and the patterns of a recipe
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
 * Return why the recipe's pattern table does not have the required patterns, as a clause with
 * advice, or an empty string if it does.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindPatternError(vtkAdaptiveRefinement* recipe);

/**
 * Return the requirements of the recipe that its patterns do not meet, although they can refine, as
 * sentences with advice. Returns an empty string if there are none.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::string FindPatternWarning(vtkAdaptiveRefinement* recipe);

/**
 * Return the patterns of a recipe for an input, or substitutes if there is an error.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::shared_ptr<const PatternFamily> GetPatternFamily(
  vtkAdaptiveRefinement* recipe, vtkPolyData* input);

/**
 * Return the patterns of a recipe without morphing.
 */
RELEVOFILTERSREFINEMENT_EXPORT std::shared_ptr<const PatternFamily> GetRoundedPatternFamily(
  vtkAdaptiveRefinement* recipe);

/**
 * Return the level that a metric's tags are limited to. It is MaximumLevel, but higher for an
 * absolute metric if an offset of the recipe or a budget (`isMoved`) may reduce tags.
 */
RELEVOFILTERSREFINEMENT_EXPORT int GetHighestTag(vtkAdaptiveRefinement* recipe, bool isMoved);

/**
 * Return the metric that provides the levels, or nullptr if there is an array or no metric.
 */
RELEVOFILTERSREFINEMENT_EXPORT vtkDepthTagMetric* GetMetricInUse(
  vtkAdaptiveRefinement* recipe, vtkDataSet* input);

/// Return the array that provides the levels, or nullptr if the input does not have it.
RELEVOFILTERSREFINEMENT_EXPORT vtkAbstractArray* FindDepthTagArray(
  vtkAdaptiveRefinement* recipe, vtkDataSet* input);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Recipe/RecipeLevels.h"

#include "Patterns/PatternLibrary.h"
#include "vtkAbstractArray.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDataSet.h"
#include "vtkDepthTagMetric.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

namespace relevo
{
int GetHighestTag(vtkAdaptiveRefinement* recipe, bool isMoved)
{
  vtkDepthTagMetric* metric = recipe->GetMetric();
  const bool isOpen =
    metric && metric->IsAbsolute() && (isMoved || recipe->GetLevelOffset() != 0.0);
  return recipe->GetMaximumLevel() + (isOpen ? vtkRefinementPatternTable::HighestLevel + 1 : 0);
}

vtkAbstractArray* FindDepthTagArray(vtkAdaptiveRefinement* recipe, vtkDataSet* input)
{
  const char* name = recipe->GetDepthTagArrayName();
  return name[0] ? input->GetPointData()->GetAbstractArray(name) : nullptr;
}

vtkDepthTagMetric* GetMetricInUse(vtkAdaptiveRefinement* recipe, vtkDataSet* input)
{
  return FindDepthTagArray(recipe, input) ? nullptr : recipe->GetMetric();
}

std::string FindPatternError(vtkAdaptiveRefinement* recipe)
{
  const PatternLibrary& library = *recipe->GetPatternTable()->GetLibrary();
  if (recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS)
  {
    return library.GetError(PatternLibrary::WHOLE_NUMBERS);
  }
  return recipe->GetGeomorphing() == vtkAdaptiveRefinement::GEOMORPHING_ON
    ? library.GetError(PatternLibrary::NESTED)
    : std::string();
}

std::string FindPatternWarning(vtkAdaptiveRefinement* recipe)
{
  const PatternLibrary& library = *recipe->GetPatternTable()->GetLibrary();
  if (recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS &&
    recipe->GetGeomorphing() == vtkAdaptiveRefinement::GEOMORPHING_ON)
  {
    return "Geomorphing has no effect: edges have whole numbers of segments, and only 2^level "
           "segments can "
           "morph. "
           "Call SetSegmentPolicyToPowersOfTwo() or GeomorphingOff().";
  }
  return recipe->GetAskedMaximumLevel() > library.GetHighestLevel() ? "MaximumLevel is " +
      std::to_string(recipe->GetAskedMaximumLevel()) + ", but the patterns of " +
      library.GetFileName() + " end at level " + std::to_string(library.GetHighestLevel()) +
      ". Call SetMaximumLevel(), or set another table with SetPatternTable()."
                                                                    : std::string();
}

std::shared_ptr<const PatternFamily> GetPatternFamily(
  vtkAdaptiveRefinement* recipe, vtkPolyData* input)
{
  const bool wholeNumbers = recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
  const int morphing = recipe->GetGeomorphing();
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input);
  const bool automatic = metric && metric->IsViewDependent();
  std::shared_ptr<const PatternFamily> nested;
  if (!wholeNumbers &&
    (morphing == vtkAdaptiveRefinement::GEOMORPHING_ON ||
      (morphing == vtkAdaptiveRefinement::GEOMORPHING_AUTOMATIC && automatic)))
  {
    nested = recipe->GetPatternTable()->GetLibrary()->GetFamily(PatternLibrary::NESTED);
  }
  return nested ? nested : GetRoundedPatternFamily(recipe);
}

std::shared_ptr<const PatternFamily> GetRoundedPatternFamily(vtkAdaptiveRefinement* recipe)
{
  const PatternLibrary& library = *recipe->GetPatternTable()->GetLibrary();
  const auto family = recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS
    ? library.GetFamily(PatternLibrary::WHOLE_NUMBERS)
    : nullptr;
  return family ? family : library.GetFamily(PatternLibrary::POWERS_OF_TWO);
}
}

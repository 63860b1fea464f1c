// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/FaceColorStage.h"

#include "Checks/ShouldReport.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkLookupTable.h"

namespace relevo
{
namespace
{
bool HasWholeNumbers(vtkAdaptiveRefinement* recipe)
{
  return recipe && recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
}
}

vtkScalarsToColors* FaceColorStage::GetDefaultTable(int mode, vtkAdaptiveRefinement* recipe)
{
  return this->DefaultTable.Get(
    mode, HasWholeNumbers(recipe), recipe ? recipe->GetMaximumLevel() : 0);
}

StageResult FaceColorStage::Update(const Input& input)
{
  StageResult result;
  if (input.Mode == COLOR_BY_SCALARS)
  {
    return result;
  }
  vtkScalarsToColors* table = input.Table;
  const std::string error = ColorTable::FindError(table, table->GetRange());
  if (ShouldReport(this->TableError, error))
  {
    result.Errors.push_back("Cannot colour by levels, patterns or tags: " + error + ".");
  }
  if (!error.empty())
  {
    table = this->GetDefaultTable(input.Mode, input.Recipe);
  }
  const bool isUploaded = this->Upload(input, table);
  if (ShouldReport(this->SizeError, isUploaded ? "" : BufferTexture::GetTooLarge()))
  {
    result.Errors.push_back(
      "The colours of levels, patterns or tags do not fit on the graphics card: " +
      this->SizeError + ".");
  }
  return result;
}

bool FaceColorStage::Upload(const Input& input, vtkScalarsToColors* table)
{
  const bool wholeNumbers = HasWholeNumbers(input.Recipe);
  if (input.Mode == COLOR_BY_METRIC)
  {
    return this->Colors.UploadTags(input.Window, *input.Mesh, *input.Selection,
      input.Recipe->GetLevelOffset() + input.LevelOffset, input.Recipe->GetMaximumLevel(), table);
  }
  return input.Patterns
    ? this->Colors.UploadPatterns(input.Window, input.Mode, wholeNumbers, *input.Patterns, table)
    : this->Colors.UploadFaces(input.Window, input.Mode, wholeNumbers, *input.Selection, table);
}

void FaceColorStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Colors.ReleaseGraphicsResources(window);
  this->SizeError.clear();
}
}

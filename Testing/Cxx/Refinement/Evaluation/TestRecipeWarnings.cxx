// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinement promises one warning for each setting that has no effect: levels that a
// pattern file lacks, and geomorphing with whole numbers of segments. A height map that cannot be
// read is an error of the filter.
#include "RelevoCheck.h"
#include "RelevoPatternFiles.h"
#include "RelevoTestMeshes.h"
#include "RelevoWarnings.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkExecutive.h"
#include "vtkObjectFactory.h"
#include "vtkRefinedCellLocator.h"
#include "vtkRefinementPatternTable.h"
#include "vtkTestUtilities.h"

#include <string>

namespace
{
using namespace RelevoMeshes;

constexpr int FileLevel = 4;

struct Subject
{
  explicit Subject(vtkAdaptiveRefinement* recipe)
    : OfFilter(this->Filter)
    , OfLocator(this->Locator)
  {
    this->Filter->SetInputData(this->Input);
    this->Filter->SetRefinement(recipe);
    this->Locator->SetDataSet(this->Input);
    this->Locator->SetRefinement(recipe);
  }
  vtkIdType Run()
  {
    this->Filter->Update();
    this->Locator->BuildLocator();
    return this->Filter->GetOutput()->GetNumberOfPolys();
  }
  // Whether filter and locator each warned this many times, the last time with these words.
  bool HaveWarned(int number, const std::string& words) const
  {
    return this->OfFilter.Number == number && this->OfLocator.Number == number &&
      this->OfFilter.Text.find(words) != std::string::npos &&
      this->OfLocator.Text.find(words) != std::string::npos;
  }

  Mesh Input = Plane(1, 1);
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
  vtkNew<vtkRefinedCellLocator> Locator;
  RelevoWarnings OfFilter;
  RelevoWarnings OfLocator;
};

void TestLevels(RelevoCheck& check, const std::string& fileName)
{
  vtkNew<vtkRefinementPatternTable> table;
  CHECK(RelevoPatternFiles::WriteShifted(fileName, FileLevel) && table->Read(fileName.c_str()));
  const auto recipe = MakeRecipe(6);
  RelevoErrors errors(recipe);
  Subject subject(recipe);
  recipe->SetPatternTable(table);
  CHECK_EQUAL(subject.Run(), 2 * 256);
  CHECK(subject.HaveWarned(1,
    "MaximumLevel is 6, but the patterns of " + fileName +
      " end at level 4. Call SetMaximumLevel()"));
  recipe->SetLevelOffset(1.0);
  subject.Run();
  CHECK(subject.HaveWarned(1, "is 6"));
  recipe->SetMaximumLevel(FileLevel);
  subject.Run();
  CHECK(subject.HaveWarned(1, "is 6"));
  CHECK(errors.None());
}

// A table whose level was never set does not lower that of a recipe, in either order.
void TestPlainTable(RelevoCheck& check)
{
  for (const bool levelFirst : { true, false })
  {
    CHECK_CASE(levelFirst);
    vtkNew<vtkAdaptiveRefinement> recipe;
    RelevoErrors errors(recipe);
    vtkNew<vtkRefinementPatternTable> table;
    if (levelFirst)
    {
      recipe->SetMaximumLevel(7);
    }
    recipe->SetPatternTable(table);
    recipe->SetMaximumLevel(7);
    CHECK(recipe->GetMaximumLevel() == 7 && table->GetMaximumLevel() == 5 && errors.None());
    const vtkMTimeType time = recipe->GetMTime();
    table->SetMaximumLevel(5);
    CHECK_EQUAL(recipe->GetMaximumLevel(), 5);
    CHECK_GREATER(recipe->GetMTime(), time);
  }
}

void TestMorphing(RelevoCheck& check)
{
  const auto recipe = MakeRecipe(2);
  Subject subject(recipe);
  recipe->SetSegmentPolicyToWholeNumbers();
  CHECK(subject.Run() == 2 * 16 && subject.HaveWarned(0, ""));
  recipe->GeomorphingOn();
  CHECK_EQUAL(subject.Run(), 2 * 16);
  CHECK(subject.HaveWarned(1, "SetSegmentPolicyToPowersOfTwo() or GeomorphingOff()"));
  recipe->SetLevelOffset(-1.0);
  subject.Run();
  CHECK(subject.HaveWarned(1, "Geomorphing has no effect"));
  recipe->GeomorphingOff();
  subject.Run();
  recipe->GeomorphingOn();
  subject.Run();
  CHECK(subject.HaveWarned(2, "Geomorphing has no effect"));
}

class NoHeights : public RelevoHeights
{
public:
  static NoHeights* New();
  const char* GetErrorMessage() override { return "the disk has gone"; }
};
vtkStandardNewMacro(NoHeights);

void TestHeights(RelevoCheck& check)
{
  vtkNew<NoHeights> heights;
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  Subject subject(MakeRecipe(2, nullptr, displacement));
  RelevoErrors errors(subject.Filter);
  RelevoErrors ofLocator(subject.Locator);
  RelevoErrors ofHeights(heights);
  RelevoErrors ofDisplacement(displacement);
  RelevoErrors ofExecutive(subject.Filter->GetExecutive());
  const std::string words = "The displacement's height map could not be read: the disk has gone";
  CHECK_EQUAL(subject.Run(), 0);
  CHECK(errors.Said(words) && ofLocator.Said(words));
}
}

int TestRecipeWarnings(int argc, char* argv[])
{
  RelevoCheck check;
  char* folder =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string fileName = std::string(folder) + "/RecipeShortfalls.patterns";
  delete[] folder;
  TestLevels(check, fileName);
  TestPlainTable(check);
  TestMorphing(check);
  TestHeights(check);
  return check.GetResult();
}

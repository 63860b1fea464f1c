// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that recipes with their default tables share patterns: each pattern is created once, also
// with several threads, and freed with its last user.
#include "RelevoCheck.h"
#include "RelevoPatternFiles.h"
#include "RelevoTestMeshes.h"

#include "Patterns/PatternFamily.h"
#include "Patterns/PatternLibrary.h"
#include "vtkRefinementPatternTable.h"
#include "vtkTestUtilities.h"

#include <array>
#include <memory>
#include <string>
#include <thread>

namespace
{
using namespace RelevoMeshes;
using Library = relevo::PatternLibrary;
using Pattern = std::shared_ptr<const relevo::RefinementPattern>;
using Recipe = vtkSmartPointer<vtkAdaptiveRefinement>;

// Returns one pattern of each family.
std::array<Pattern, 3> GetPatterns(vtkAdaptiveRefinement* recipe)
{
  const Library& library = *recipe->GetPatternTable()->GetLibrary();
  std::array<Pattern, 3> patterns;
  std::size_t i = 0;
  for (const auto kind : { Library::POWERS_OF_TWO, Library::WHOLE_NUMBERS, Library::NESTED })
  {
    patterns[i++] = library.GetFamily(kind)->GetPattern(60);
  }
  return patterns;
}

void TestOnce(RelevoCheck& check)
{
  const Recipe first = MakeRecipe(4);
  const Recipe second = MakeRecipe(4);
  const Mesh mesh = Tagged(Sphere(9, 7), 4);
  Refine(mesh, first);
  const vtkTypeInt64 made = first->GetPatternTable()->GetMemorySize();
  CHECK_GREATER(made, 0);
  Refine(mesh, second);
  CHECK_EQUAL(second->GetPatternTable()->GetMemorySize(), made);
  CHECK_EQUAL(GetPatterns(first), GetPatterns(second));
}

void TestLast(RelevoCheck& check)
{
  Recipe first = MakeRecipe(4);
  Recipe second = MakeRecipe(4);
  const std::weak_ptr<const relevo::RefinementPattern> watched = GetPatterns(first)[0];
  first = nullptr;
  CHECK(!watched.expired() && GetPatterns(second)[0] == watched.lock());
  second = nullptr;
  CHECK(watched.expired());
}

void TestThreads(RelevoCheck& check)
{
  std::array<Recipe, 4> recipes;
  std::array<std::array<Pattern, 3>, 4> seen;
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    threads.emplace_back(
      [&recipes, &seen, i]
      {
        recipes[i] = MakeRecipe(4);
        seen[i] = GetPatterns(recipes[i]);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  const Recipe last = MakeRecipe(4);
  for (const auto& patterns : seen)
  {
    CHECK_EQUAL(patterns, GetPatterns(last));
  }
}

// A file that one table reads affects only the recipes of that table.
void TestFile(RelevoCheck& check, const std::string& fileName)
{
  const Recipe reading = MakeRecipe(3);
  const Recipe other = MakeRecipe(3);
  const auto before = GetPatterns(other);
  CHECK(RelevoPatternFiles::WriteShifted(fileName, 4));
  CHECK(reading->GetPatternTable()->Read(fileName.c_str()));
  CHECK_EQUAL(GetPatterns(other), before);
  const auto family = reading->GetPatternTable()->GetLibrary()->GetFamily(Library::POWERS_OF_TWO);
  CHECK_NOT_EQUAL(family->GetPattern(60), before[0]);
}
}

int TestPatternSharing(int argc, char* argv[])
{
  RelevoCheck check;
  char* folder =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string fileName = std::string(folder) + "/PatternSharing.patterns";
  delete[] folder;
  TestOnce(check);
  TestLast(check);
  TestThreads(check);
  TestFile(check, fileName);
  return check.GetResult();
}

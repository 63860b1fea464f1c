// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that recipes with the same table share its patterns, also between threads. Patterns and
// families live as long as they are used and no longer. Each recipe has a MaximumLevel, which the
// table's limits.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternChoice.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Metrics/MetricCache.h"
#include "Patterns/PatternLibrary.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkRefinementPatternTable.h"

#include <array>
#include <memory>
#include <thread>

namespace
{
using namespace RelevoMeshes;
using Library = relevo::PatternLibrary;

constexpr Library::Families AllFamilies[] = { Library::POWERS_OF_TWO, Library::WHOLE_NUMBERS,
  Library::NESTED };

void TestSharing(RelevoCheck& check)
{
  const Mesh mesh = Tagged(Sphere(9, 7), 4);
  vtkNew<vtkRefinementPatternTable> table;
  const auto first = MakeRecipe(4);
  const auto second = MakeRecipe(4);
  CHECK_NOT_EQUAL(first->GetPatternTable(), second->GetPatternTable());
  CHECK_NOT_EQUAL(relevo::GetPatternFamily(first, mesh), relevo::GetPatternFamily(second, mesh));
  for (const auto& recipe : { first, second })
  {
    recipe->SetPatternTable(table);
    CHECK_EQUAL(recipe->GetPatternTable(), table);
  }
  for (int mode : { vtkAdaptiveRefinement::GEOMORPHING_OFF, vtkAdaptiveRefinement::GEOMORPHING_ON })
  {
    CHECK_CASE(mode);
    first->SetGeomorphing(mode);
    second->SetGeomorphing(mode);
    CHECK_EQUAL(relevo::GetPatternFamily(first, mesh), relevo::GetPatternFamily(second, mesh));
    const vtkTypeInt64 before = table->GetMemorySize();
    Refine(mesh, first);
    const vtkTypeInt64 made = table->GetMemorySize();
    CHECK_GREATER(made, before);
    Refine(mesh, second);
    CHECK_EQUAL(table->GetMemorySize(), made);
  }

  // Families share the patterns that they have in common.
  const auto powers = table->GetLibrary()->GetFamily(Library::POWERS_OF_TWO);
  const auto whole = table->GetLibrary()->GetFamily(Library::WHOLE_NUMBERS);
  const int levels[] = { 2, 1, 0 };
  const int segments[] = { 4, 2, 1 };
  const auto keyOf = [](const int steps[3])
  { return 2 * vtkRefinementPatternTable::GetPatternIndex(steps[0], steps[1], steps[2]); };
  const int steps[] = { 3, 1, 0 }; // 4, 2 and 1 segments in the family of whole numbers
  const auto pattern = table->GetPatternOfSegments(segments[0], segments[1], segments[2]);
  CHECK_EQUAL(powers->GetPattern(keyOf(levels)), pattern);
  CHECK_EQUAL(whole->GetPattern(keyOf(steps)), pattern);
  CHECK_EQUAL(powers->GetPattern(keyOf(levels) + 1), pattern); // seen from the other side
  for (const auto kind : AllFamilies)
  {
    CHECK_EQUAL(table->GetLibrary()->GetFamily(kind), table->GetLibrary()->GetFamily(kind));
    CHECK(table->GetLibrary()->GetError(kind).empty());
  }
}

void TestLife(RelevoCheck& check)
{
  for (const auto kind : AllFamilies)
  {
    auto table = vtkSmartPointer<vtkRefinementPatternTable>::New();
    std::weak_ptr<const Library> library = table->GetLibrary();
    auto family = table->GetLibrary()->GetFamily(kind);
    std::weak_ptr<const relevo::PatternFamily> watched = family;
    auto kept = family->GetPattern(10);
    const auto before = *kept;
    table = nullptr;
    CHECK(library.expired());
    // A family can still create patterns.
    CHECK_GREATER(family->GetPattern(20)->GetNumberOfTriangles(), 0);
    CHECK_EQUAL(family->GetPattern(10), kept);
    family = nullptr;
    CHECK(watched.expired());
    CHECK_EQUAL(kept->Vertices, before.Vertices);
    CHECK_EQUAL(kept->Triangles, before.Triangles);
    std::weak_ptr<const relevo::RefinementPattern> last = kept;
    kept = nullptr;
    CHECK(last.expired());
  }
}

// A selection can be read after its recipe is deleted.
void TestSelectionLife(RelevoCheck& check)
{
  const Mesh input = Tagged(Sphere(9, 7), 4);
  for (int mode : { vtkAdaptiveRefinement::GEOMORPHING_OFF, vtkAdaptiveRefinement::GEOMORPHING_ON })
  {
    CHECK_CASE(mode);
    auto recipe = MakeRecipe(4);
    recipe->SetGeomorphing(mode);
    const vtkIdType expected = Refine(input, recipe)->GetNumberOfPolys();
    relevo::RefinementMesh mesh;
    relevo::PatternSelection selection;
    std::string error;
    std::string warning;
    CHECK(relevo::PrepareMesh(input, recipe, nullptr, mesh, error, warning));
    const auto tags = std::make_shared<relevo::MetricCache>();
    CHECK(relevo::SelectPatterns(
      input, recipe, relevo::RefinementView(), mesh, tags, selection, error));
    recipe = nullptr;
    vtkIdType triangles = 0;
    for (int face = 0; face < selection.GetNumberOfFaces(); ++face)
    {
      const relevo::FacePattern pattern = selection.GetFacePattern(face);
      float weights[3];
      pattern.GetWeights(0, weights);
      CHECK_EQUAL(weights[0] + weights[1] + weights[2], 1.0f);
      triangles += pattern.Pattern->GetNumberOfTriangles();
    }
    CHECK_EQUAL(triangles, expected);
    selection.Group();
    CHECK_EQUAL(selection.GetNumberOfGroupedTriangles(), expected);
  }
}

void TestPatternsInThreads(RelevoCheck& check)
{
  vtkNew<vtkRefinementPatternTable> table;
  constexpr int NumberOfThreads = 4;
  std::array<relevo::RefinementPatterns, NumberOfThreads> seen;
  std::vector<std::thread> threads;
  for (auto& patterns : seen)
  {
    threads.emplace_back(
      [&]
      {
        for (const auto kind : AllFamilies)
        {
          const auto family = table->GetLibrary()->GetFamily(kind);
          for (int key = 0; key < 60; ++key)
          {
            patterns.push_back(family->GetPattern(key));
          }
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& patterns : seen)
  {
    CHECK_EQUAL(patterns, seen[0]);
  }
}

// Two filters in two threads use one table.
void TestFiltersInThreads(RelevoCheck& check)
{
  const Mesh mesh = Tagged(Sphere(15, 11), 5);
  const auto configure = [](vtkAdaptiveRefinement* recipe, int kind)
  {
    recipe->SetGeomorphing(kind == Library::NESTED ? vtkAdaptiveRefinement::GEOMORPHING_ON
                                                   : vtkAdaptiveRefinement::GEOMORPHING_OFF);
    recipe->SetSegmentPolicy(kind == Library::WHOLE_NUMBERS);
  };
  for (const auto kind : AllFamilies)
  {
    const auto alone = MakeRecipe(5);
    configure(alone, kind);
    const Mesh expected = Refine(mesh, alone);
    vtkNew<vtkRefinementPatternTable> table;
    std::array<Mesh, 2> inputs;
    std::array<Mesh, 2> outputs;
    std::vector<vtkSmartPointer<vtkAdaptiveRefinement>> recipes;
    for (Mesh& input : inputs)
    {
      input = Make();
      input->DeepCopy(mesh);
      recipes.push_back(MakeRecipe(5));
      configure(recipes.back(), kind);
      recipes.back()->SetPatternTable(table);
    }
    std::thread other([&] { outputs[1] = Refine(inputs[1], recipes[1]); });
    outputs[0] = Refine(inputs[0], recipes[0]);
    other.join();
    for (vtkPolyData* output : outputs)
    {
      CHECK_EQUAL(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
      CHECK_EQUAL(output->GetNumberOfPolys(), expected->GetNumberOfPolys());
      vtkIdType wrong = 0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        std::array<double, 3> a;
        std::array<double, 3> b;
        output->GetPoint(i, a.data());
        expected->GetPoint(i, b.data());
        wrong += a != b ? 1 : 0;
      }
      CHECK_EQUAL(wrong, 0);
    }
  }
}

void TestMaximumLevel(RelevoCheck& check)
{
  const Mesh mesh = Plane(1, 1);
  vtkNew<vtkRefinementPatternTable> table;
  table->SetMaximumLevel(4);
  const auto first = MakeRecipe(2);
  const auto second = MakeRecipe(3);
  RelevoErrors errors(first);
  first->SetPatternTable(table);
  second->SetPatternTable(table);
  // A recipe's MaximumLevel is independent of the table's other recipes.
  for (int level : { 0, 4, 1, 3 })
  {
    CHECK_CASE(level);
    first->SetMaximumLevel(level);
    CHECK_EQUAL(first->GetMaximumLevel(), level);
    CHECK_EQUAL(second->GetMaximumLevel(), 3);
    CHECK_EQUAL(table->GetMaximumLevel(), 4);
    CHECK(Refine(mesh, first)->GetNumberOfPolys() == vtkIdType(2) << 2 * level);
    CHECK_EQUAL(Refine(mesh, second)->GetNumberOfPolys(), 2 * 64);
  }
  CHECK(errors.None());
  first->SetMaximumLevel(5);
  CHECK(errors.Said("MaximumLevel must be in [0, 4], got 5. The pattern table"));
  first->SetMaximumLevel(8);
  CHECK(errors.Said("MaximumLevel must be in [0, 4], got 8."));
  first->SetMaximumLevel(-1);
  CHECK(errors.Said("MaximumLevel must be in [0, 4], got -1."));
  CHECK_EQUAL(first->GetMaximumLevel(), 3);
  // The table's MaximumLevel is the limit.
  const vtkMTimeType time = first->GetMTime();
  table->SetMaximumLevel(1);
  CHECK_EQUAL(first->GetMaximumLevel(), 1);
  CHECK_GREATER(first->GetMTime(), time);
  CHECK_EQUAL(Refine(mesh, first)->GetNumberOfPolys(), 2 * 4);
  table->SetMaximumLevel(7);
  CHECK_EQUAL(first->GetMaximumLevel(), 3);
  first->SetPatternTable(nullptr);
  CHECK(first->GetPatternTable() != table && first->GetPatternTable()->GetMaximumLevel() == 7);
  CHECK_EQUAL(first->GetMaximumLevel(), 3);
  first->SetMaximumLevel(7);
  CHECK(first->GetMaximumLevel() == 7 && errors.None());
}
}

int TestPatternLibrary(int, char*[])
{
  RelevoCheck check;
  TestSharing(check);
  TestLife(check);
  TestSelectionLife(check);
  TestPatternsInThreads(check);
  TestFiltersInThreads(check);
  TestMaximumLevel(check);
  return check.GetResult();
}

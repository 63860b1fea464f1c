// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises with AllPairsOn() each pair of intersecting cells once. The
// references are separating axes in whole numbers for all pairs of triangles, also for
// self-intersection, polygons, and coarse cells of a recipe.
#include "RelevoCheck.h"
#include "RelevoIntersections.h"
#include "RelevoTestMeshes.h"
#include "RelevoTrianglePairs.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSurfaceIntersectionFilter.h"

#include <iostream>
#include <set>
#include <utility>

namespace
{
using Pairs = std::set<std::pair<vtkIdType, vtkIdType>>;

// Fails if a pair occurs twice or out of order.
Pairs GetPairs(RelevoCheck& check, vtkSurfaceIntersectionFilter* filter)
{
  filter->Update();
  Pairs pairs;
  vtkFieldData* data = filter->GetOutput(0)->GetFieldData();
  auto* first = vtkIdTypeArray::SafeDownCast(data->GetArray("AllInput0CellID"));
  auto* second = vtkIdTypeArray::SafeDownCast(data->GetArray("AllInput1CellID"));
  CHECK(first && second && first->GetNumberOfValues() == second->GetNumberOfValues());
  for (vtkIdType i = 0; first && second && i < first->GetNumberOfValues(); ++i)
  {
    pairs.emplace_hint(pairs.end(), first->GetValue(i), second->GetValue(i));
  }
  CHECK(first && static_cast<vtkIdType>(pairs.size()) == first->GetNumberOfValues());
  return pairs;
}

// Coordinates are small, so many triangles touch in a corner, along an edge, or are coplanar.
void TestWhole(RelevoCheck& check, RelevoDice& dice, int side, size_t& pairs, size_t& named)
{
  const RelevoWholeMesh first(dice, side, 8, 12);
  const RelevoWholeMesh second(dice, side, 7, 10);
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, first.NewPolyData());
  filter->SetInputData(1, second.NewPolyData());
  filter->AllPairsOn();
  Pairs expected;
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 10; ++j)
    {
      if (RelevoMeet(first.GetCorners(i), second.GetCorners(j)))
      {
        expected.emplace(i, j);
      }
    }
  }
  CHECK_EQUAL(GetPairs(check, filter), expected);
  pairs += expected.size();
  Pairs ofCells = RelevoGetCellPairs(filter->GetOutput(0));
  const Pairs ofOverlaps = RelevoGetCellPairs(filter->GetOutput(1));
  ofCells.insert(ofOverlaps.begin(), ofOverlaps.end());
  named += ofCells.size();

  filter->SetInputData(1, nullptr);
  expected.clear();
  for (int i = 0; i < 12; ++i)
  {
    for (int j = i + 1; j < 12; ++j)
    {
      if (RelevoMeetBeyond(first, i, j))
      {
        expected.emplace(i, j);
      }
    }
  }
  CHECK_EQUAL(GetPairs(check, filter), expected);
}

// Two boxes that share a corner: three faces of each meet at this vertex.
void TestCorner(RelevoCheck& check)
{
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, RelevoMakeBox(0.0, 1.0));
  filter->SetInputData(1, RelevoMakeBox(1.0, 2.0));
  filter->Update();
  CHECK_EQUAL(filter->GetOutput(0)->GetNumberOfCells(), 1);
  CHECK(!filter->GetOutput(0)->GetFieldData()->HasArray("AllInput0CellID"));
  filter->AllPairsOn();
  CHECK_EQUAL(GetPairs(check, filter).size(), 9);
  CHECK_EQUAL(filter->GetOutput(0)->GetNumberOfCells(), 1);
  // If the boxes are apart, the arrays are empty.
  filter->SetMatrix(1, RelevoMakeMotion({ 5.0, 0.0, 0.0 }, 0.0, { 0.0, 0.0, 1.0 }));
  CHECK(GetPairs(check, filter).empty());
}

// The coarse cells of a recipe are those of the flat mesh if it refines to the same surface.
void TestRecipe(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  const auto first = RelevoMakeSphere(9, { 0.0, 0.0, 0.0 }, 1.0);
  const auto second = RelevoMakeSphere(7, { 0.5, 0.2, 0.1 }, 0.8);
  vtkNew<vtkSurfaceIntersectionFilter> flat;
  vtkNew<vtkSurfaceIntersectionFilter> curved;
  for (vtkSurfaceIntersectionFilter* filter : { flat.Get(), curved.Get() })
  {
    filter->SetInputData(0, first);
    filter->SetInputData(1, second);
    filter->AllPairsOn();
  }
  curved->SetRefinement(0, recipe);
  curved->SetRefinement(1, recipe);
  const Pairs expected = GetPairs(check, flat);
  std::cout << expected.size() << " pairs of coarse cells\n";
  CHECK_GREATER(expected.size(), 20);
  CHECK_EQUAL(GetPairs(check, curved), expected);
}
}

int TestSurfaceIntersectionAllPairs(int, char*[])
{
  RelevoCheck check;
  RelevoDice dice(7);
  size_t pairs = 0;
  size_t named = 0;
  for (int i = 0; i < 500; ++i)
  {
    TestWhole(check, dice, 3 + i % 6, pairs, named);
  }
  std::cout << pairs << " pairs, of which curves and overlaps name " << named << "\n";
  CHECK_LESS(named, pairs);
  TestCorner(check);
  TestRecipe(check);
  return check.GetResult();
}

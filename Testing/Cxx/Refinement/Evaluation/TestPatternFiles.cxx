// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinementPatternTable promises: patterns read from a file refine every surface without
// cracks. A feature that they do not support gives one error that says what to do.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoPatternFiles.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkDisplacement.h"
#include "vtkExecutive.h"
#include "vtkRefinementPatternTable.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkTestUtilities.h"

#include <array>
#include <set>

namespace
{
using namespace RelevoMeshes;

constexpr int FileLevel = 4;

using Places = std::set<std::array<double, 3>>;

Places GetPlaces(vtkPolyData* mesh)
{
  Places places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    mesh->GetPoint(i, p.data());
    places.insert(p);
  }
  return places;
}

void TestPlaces(RelevoCheck& check, vtkRefinementPatternTable* table)
{
  const Mesh triangle =
    FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
  const auto recipe = MakeRecipe(3);
  const Places generated = GetPlaces(Refine(triangle, recipe));
  recipe->SetPatternTable(table);
  const Places read = GetPlaces(Refine(triangle, recipe));
  vtkNew<vtkPolyData> pattern;
  CHECK(table->GetPattern(3, 3, 3, pattern));
  CHECK_EQUAL(read, GetPlaces(pattern));
  CHECK(read != generated && read.size() == generated.size());
}

void TestSurfaces(RelevoCheck& check, vtkRefinementPatternTable* table)
{
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(64, 64, 9);
  auto displacement = MakeDisplacement(rough, 0.05);
  Mesh mesh = Tagged(TexturedSphere(10, 7), FileLevel);
  AddRandomScalarTags(mesh, 4);
  for (const auto& surface : RelevoMakeSurfaces(0.3))
  {
    for (vtkDisplacement* displaced :
      { static_cast<vtkDisplacement*>(nullptr), displacement.Get() })
    {
      const auto recipe = MakeRecipe(FileLevel, surface.second, displaced);
      const Mesh generated = Refine(mesh, recipe);
      recipe->SetPatternTable(table);
      const Mesh read = Refine(mesh, recipe);
      const std::string error = RelevoWatertight::FindError(mesh, read, FileLevel);
      if (!error.empty())
      {
        check.Fail(__FILE__, __LINE__, surface.first + ": " + error);
      }
      CHECK_EQUAL(read->GetNumberOfPolys(), generated->GetNumberOfPolys());
      CHECK_NOT_EQUAL(GetPlaces(read), GetPlaces(generated));
    }
  }
}

void TestErrors(RelevoCheck& check, vtkRefinementPatternTable* table)
{
  const Mesh mesh = Plane(2, 2);
  const auto recipe = MakeRecipe(2);
  recipe->SetPatternTable(table);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(mesh);
  filter->SetRefinement(recipe);
  RelevoErrors errors(filter);
  const auto refuses = [&](const std::string& words)
  {
    const RelevoErrors executiveErrors(filter->GetExecutive());
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
    CHECK(errors.Said(words));
  };
  const auto refines = [&]
  {
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 8 * 16);
    CHECK(errors.None());
  };
  recipe->GeomorphingOn();
  refuses("GeomorphingOff()");
  recipe->GeomorphingOff();
  refines();
  recipe->SetSegmentPolicyToWholeNumbers();
  refuses("SetSegmentPolicyToPowersOfTwo()");
  recipe->SetPatternTable(nullptr);
  refines();
  recipe->SetSegmentPolicyToPowersOfTwo();
  recipe->GeomorphingOn();
  refines();

  // Automatic geomorphing is turned off.
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  metric->SetReferenceLength(0.1); // all edges get the highest level
  vtkNew<vtkCamera> camera;
  filter->SetCamera(camera);
  filter->SetViewportSize(400, 300);
  recipe->SetMetric(metric);
  recipe->SetGeomorphing(vtkAdaptiveRefinement::GEOMORPHING_AUTOMATIC);
  recipe->SetPatternTable(table);
  refines();
  vtkNew<vtkAdaptiveRefinement> plain;
  plain->SetMaximumLevel(2);
  plain->SetPatternTable(table);
  CHECK_EQUAL(GetPlaces(filter->GetOutput()), GetPlaces(Refine(mesh, plain)));
}

// Levels are limited to those in the file.
void TestLevels(RelevoCheck& check, const std::string& fileName)
{
  const auto recipe = MakeRecipe(6);
  const vtkSmartPointer<vtkRefinementPatternTable> table = recipe->GetPatternTable();
  RelevoErrors errors(recipe);
  RelevoErrors tableErrors(table);
  CHECK(table->Read(fileName.c_str()));
  CHECK_EQUAL(table->GetMaximumLevel(), FileLevel);
  CHECK_EQUAL(recipe->GetMaximumLevel(), FileLevel);
  CHECK_EQUAL(Refine(Plane(1, 1), recipe)->GetNumberOfPolys(), 2 * 256);
  table->SetMaximumLevel(FileLevel + 1);
  CHECK(tableErrors.Said("The file of the patterns has no higher level"));
  CHECK_EQUAL(table->GetMaximumLevel(), FileLevel);
  recipe->SetMaximumLevel(FileLevel + 1);
  CHECK(errors.Said("[0, 4], got 5. The pattern table has no higher level"));
  recipe->SetPatternTable(nullptr);
  CHECK_EQUAL(recipe->GetMaximumLevel(), 6);
  recipe->SetMaximumLevel(5);
  CHECK_EQUAL(recipe->GetMaximumLevel(), 5);
  recipe->SetMaximumLevel(2);
  CHECK(recipe->GetPatternTable()->Read(fileName.c_str()) && recipe->GetMaximumLevel() == 2);
  CHECK(errors.None() && tableErrors.None());
}
}

int TestPatternFiles(int argc, char* argv[])
{
  RelevoCheck check;
  char* folder =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string fileName = std::string(folder) + "/PatternFiles.patterns";
  delete[] folder;
  vtkNew<vtkRefinementPatternTable> table;
  if (CHECK(RelevoPatternFiles::WriteShifted(fileName, FileLevel)) &&
    CHECK(table->Read(fileName.c_str())))
  {
    TestPlaces(check, table);
    TestSurfaces(check, table);
    TestErrors(check, table);
    TestLevels(check, fileName);
  }
  return check.GetResult();
}

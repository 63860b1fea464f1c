// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkScalarTaggedSurface promises an error that names the array for each array it cannot use.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkScalarTaggedSurface.h"
#include "vtkStringArray.h"

#include <limits>

using namespace RelevoMeshes;

namespace
{
void testErrors(RelevoCheck& check)
{
  vtkNew<vtkScalarTaggedSurface> surface;
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(MakeRecipe(2, surface));
  const auto fails =
    [&](const char* name, int components, vtkIdType tuples, double value, const std::string& words)
  {
    Mesh sphere = Sphere(6, 5);
    AddScalarTags(sphere, "Sharpness");
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples < 0 ? sphere->GetNumberOfPoints() : tuples);
    array->Fill(0.5);
    array->SetComponent(2, components - 1, value);
    sphere->GetPointData()->AddArray(array);
    filter->SetInputData(sphere);
    RelevoErrors errors(filter);
    filter->Update();
    if (words.empty())
    {
      return errors.None() && filter->GetOutput()->GetNumberOfCells() > 0;
    }
    return errors.Said(std::string("\"") + name + "\"" + words) &&
      filter->GetOutput()->GetNumberOfCells() == 0;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const char* name : { "Sharpness", "Tension", "Bias" })
  {
    CHECK_CASE(name);
    CHECK(fails(name, 1, -1, 0.5, ""));
    CHECK(fails(name, 2, -1, 0.5, " has 20 tuples of 2 components, but 20 tuples of 1 are needed"));
    CHECK(fails(name, 1, 3, 0.5, " has 3 tuples"));
    CHECK(fails(name, 1, -1, nan, " is not finite at point 2"));
    CHECK(fails(name, 1, -1, -infinity, " is not finite at point 2"));
  }
  CHECK(fails("Direction", 3, -1, 0.5, ""));
  CHECK(fails(
    "Direction", 1, -1, 0.5, " has 20 tuples of 1 components, but 20 tuples of 3 are needed"));
  CHECK(fails("Direction", 3, -1, nan, " is not finite at point 2"));
  // Arrays that are not used may contain anything.
  surface->SetDirectionArrayName(nullptr);
  CHECK_EQUAL(surface->GetDirectionArrayName(), std::string());
  CHECK(fails("Direction", 1, -1, nan, ""));
  surface->SetTensionArrayName("T");
  CHECK_EQUAL(surface->GetTensionArrayName(), std::string("T"));
  CHECK(fails("Tension", 1, -1, nan, ""));
  CHECK(fails("T", 1, -1, nan, " is not finite"));
  surface->SetBiasArrayName("B");
  CHECK(fails("B", 1, 4, 0.0, " has 4 tuples"));
  surface->SetSharpnessArrayName("S");
  CHECK(fails("S", 1, 4, 0.0, " has 4 tuples"));
  // An array of strings is not numeric.
  Mesh sphere = Sphere(6, 5);
  vtkNew<vtkStringArray> words;
  words->SetName("S");
  words->SetNumberOfValues(sphere->GetNumberOfPoints());
  sphere->GetPointData()->AddArray(words);
  filter->SetInputData(sphere);
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.Said("\"S\""));
}
}

int TestScalarTaggedSurfaceErrors(int, char*[])
{
  RelevoCheck check;
  testErrors(check);
  return check.GetResult();
}

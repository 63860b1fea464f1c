// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurfaceFilter promises arrays of the grid on refined surfaces: all types, missing values,
// and weights far from 1.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPatchSurface.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkSmartPointer<vtkPolyData> Refine(vtkPolyData* mesh)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  recipe->SetMaximumLevel(3);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(recipe);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

// A quadratic triangle with the values of these six nodes.
template <typename Array>
vtkSmartPointer<vtkUnstructuredGrid> NewTriangle(const std::array<double, 6>& values)
{
  auto grid = RelevoNewCell(VTK_QUADRATIC_TRIANGLE, { 2, 2, 2 }, 0.1);
  vtkNew<Array> array;
  array->SetName("Numbers");
  vtkNew<vtkDoubleArray> exact;
  exact->SetName("Exact");
  for (double value : values)
  {
    array->InsertNextTuple1(value);
    exact->InsertNextTuple1(array->GetTuple1(array->GetNumberOfTuples() - 1));
  }
  grid->GetPointData()->AddArray(array);
  grid->GetPointData()->AddArray(exact);
  return grid;
}

// Integers are rounded and clamped to their type, because a quadratic field exceeds the values of
// its nodes.
template <typename Array>
void TestIntegers(RelevoCheck& check, double lowest, double highest)
{
  const double step = 0.1 * (highest - lowest);
  const auto grid =
    NewTriangle<Array>({ lowest + 3 * step, lowest, lowest + 7 * step, lowest, highest, highest });
  for (bool split : { false, true })
  {
    CHECK_CASE(split);
    const auto mesh = RelevoMakePatches(grid, split);
    const auto refined = Refine(mesh);
    double least = 0.0;
    double most = 0.0;
    for (vtkPolyData* data : { mesh.Get(), refined.Get() })
    {
      vtkDataArray* numbers = data->GetPointData()->GetArray("Numbers");
      vtkDataArray* exact = data->GetPointData()->GetArray("Exact");
      CHECK_EQUAL(numbers->GetDataType(), vtkNew<Array>()->GetDataType());
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        const double wanted = exact->GetTuple1(i);
        least = std::min(least, wanted - lowest);
        most = std::max(most, wanted - highest);
        CHECK_NEAR(numbers->GetTuple1(i), std::clamp(wanted, lowest, highest), 0.5001);
      }
    }
    CHECK_LESS(least, -1.0);
    CHECK_GREATER(most, 1.0);
  }
}

// Missing values never mix with others. Texture coordinates are never missing.
void TestNoData(RelevoCheck& check)
{
  auto grid = RelevoNewCell(VTK_LAGRANGE_QUADRILATERAL, { 3, 3, 1 }, 0.1);
  for (const char* name : { "Scalars", "Vectors", "Coordinates" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(*name == 'S' ? 1 : 3);
    array->SetNumberOfTuples(grid->GetNumberOfPoints());
    array->Fill(1.0);
    grid->GetPointData()->AddArray(array);
  }
  const vtkIdType inner = grid->GetNumberOfPoints() - 1;
  grid->GetPointData()->GetArray("Scalars")->SetTuple1(inner, vtkMath::Nan());
  grid->GetPointData()->GetArray("Vectors")->SetTuple3(inner, -1e9, 0.0, 0.0);
  grid->GetPointData()->GetArray("Coordinates")->SetTuple3(inner, -1e9, 0.0, 0.0);
  grid->GetPointData()->SetActiveAttribute("Coordinates", vtkDataSetAttributes::TCOORDS);
  const auto refined = Refine(RelevoMakePatches(grid));
  CHECK_EQUAL(refined->GetNumberOfPoints(), 81);
  vtkDataArray* scalars = refined->GetPointData()->GetArray("Scalars");
  vtkDataArray* vectors = refined->GetPointData()->GetArray("Vectors");
  vtkDataArray* coordinates = refined->GetPointData()->GetTCoords();
  int without = 0;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const bool isData = scalars->GetTuple1(i) == 1.0;
    CHECK(isData || std::isnan(scalars->GetTuple1(i)));
    CHECK(std::isfinite(coordinates->GetComponent(i, 0)));
    without += isData ? 0 : 1;
    for (int c = 0; c < 3; ++c)
    {
      CHECK(isData ? vectors->GetComponent(i, c) == 1.0 : std::isnan(vectors->GetComponent(i, c)));
    }
  }
  CHECK_EQUAL(without, 77); // all but the corners
}

// The grid's field data are kept, without arrays of other patches.
void TestFieldData(RelevoCheck& check)
{
  auto grid = RelevoNewCell(VTK_QUADRATIC_TRIANGLE, { 2, 2, 2 }, 0.1);
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  note->InsertNextValue("as it was");
  grid->GetFieldData()->AddArray(note);
  for (const char* name : { "Patches", "PatchNodes:Values", "PatchNodes:Old" })
  {
    vtkNew<vtkDoubleArray> old;
    old->SetName(name);
    old->InsertNextValue(1.0);
    grid->GetFieldData()->AddArray(old);
  }
  const auto mesh = RelevoMakePatches(grid, true);
  CHECK_EQUAL(mesh->GetFieldData()->GetAbstractArray("Note"), note);
  CHECK(!mesh->GetFieldData()->HasArray("PatchNodes:Old"));
  CHECK_EQUAL(mesh->GetFieldData()->GetArray("Patches")->GetNumberOfComponents(), 4);
  CHECK_EQUAL(mesh->GetFieldData()->GetArray("PatchNodes:Values")->GetNumberOfTuples(), 6);
  CHECK_EQUAL(Refine(mesh)->GetFieldData()->GetAbstractArray("Note"), note);
}

// A common factor of all weights changes nothing, even beyond the float range.
void TestWeights(RelevoCheck& check)
{
  for (int type : { VTK_BEZIER_QUADRILATERAL, VTK_BEZIER_TRIANGLE })
  {
    CHECK_CASE(type);
    auto grid = RelevoNewCell(type, { 3, 3, 1 }, 0.1, true);
    vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
    const auto plain = Refine(RelevoMakePatches(grid));
    for (int exponent : { 600, -1300 })
    {
      CHECK_CASE(exponent);
      for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
      {
        weights->SetTuple1(i, std::ldexp(weights->GetTuple1(i), exponent));
      }
      weights->Modified();
      const auto scaled = Refine(RelevoMakePatches(grid));
      CHECK_EQUAL(scaled->GetNumberOfPoints(), plain->GetNumberOfPoints());
      for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          CHECK_EQUAL(scaled->GetPoint(i)[c], plain->GetPoint(i)[c]);
        }
      }
    }
  }
}
}

int TestPatchSurfaceArrays(int, char*[])
{
  RelevoCheck check;
  TestIntegers<vtkUnsignedCharArray>(check, 0.0, 255.0);
  TestIntegers<vtkSignedCharArray>(check, -128.0, 127.0);
  TestIntegers<vtkIntArray>(check, VTK_INT_MIN, VTK_INT_MAX);
  TestNoData(check);
  TestFieldData(check);
  TestWeights(check);
  return check.GetResult();
}

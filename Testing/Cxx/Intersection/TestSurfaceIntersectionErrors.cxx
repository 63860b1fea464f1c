// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises an error that names the input, and empty outputs, for
// meshes that it cannot intersect.
#include "RelevoCheck.h"
#include "RelevoIntersections.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSurfaceIntersectionFilter.h"

#include <functional>
#include <limits>
#include <string>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

bool IsEmpty(vtkSurfaceIntersectionFilter* filter)
{
  bool isEmpty = true;
  for (int port = 0; port < 4; ++port)
  {
    isEmpty = isEmpty && filter->GetOutput(port)->GetNumberOfCells() == 0 &&
      filter->GetOutput(port)->GetNumberOfPoints() == 0;
  }
  return isEmpty;
}

// Makes one of two boxes invalid. After a correction, the filter works again.
void ExpectError(RelevoCheck& check, const std::function<void(vtkPolyData*, vtkMatrix4x4*)>& spoil,
  const std::string& words)
{
  for (int input = 0; input < 2; ++input)
  {
    vtkNew<vtkSurfaceIntersectionFilter> filter;
    filter->SetInputData(1 - input, RelevoMakeBox(0.5, 2));
    auto good = RelevoMakeBox(0, 1);
    filter->SetInputData(input, good);
    CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
    const vtkIdType numberOfLines = filter->GetOutput()->GetNumberOfLines();
    CHECK_GREATER(numberOfLines, 0);
    auto box = RelevoMakeBox(0, 1);
    vtkNew<vtkMatrix4x4> matrix;
    spoil(box, matrix);
    filter->SetInputData(input, box);
    filter->SetMatrix(input, matrix);
    {
      RelevoErrors errors(filter);
      RelevoErrors executive(filter->GetExecutive());
      CHECK_EQUAL(filter->GetExecutive()->Update(), 0);
      const std::string expected = "Input " + std::to_string(input) + " " + words;
      if (!errors.Said(expected))
      {
        check.Fail(__FILE__, __LINE__, "no error with: " + expected);
      }
      CHECK(IsEmpty(filter));
    }
    filter->SetInputData(input, good);
    filter->SetMatrix(input, nullptr);
    RelevoErrors errors(filter);
    CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), numberOfLines);
    CHECK(errors.None());
  }
}

void TestMeshes(RelevoCheck& check)
{
  ExpectError(
    check, [](vtkPolyData* mesh, vtkMatrix4x4*) { mesh->Initialize(); },
    "has no polygons and no strips.");
  for (double x : { NaN, Infinity, -Infinity, 1.1e300 })
  {
    ExpectError(
      check, [x](vtkPolyData* mesh, vtkMatrix4x4*) { mesh->GetPoints()->SetPoint(5, 0, x, 0); },
      "has a point 5 that is not finite or exceeds 1e300.");
  }
  for (vtkIdType point : { -1, 8 })
  {
    ExpectError(
      check,
      [point](vtkPolyData* mesh, vtkMatrix4x4*)
      {
        const vtkIdType ids[3] = { 0, 1, point };
        mesh->GetPolys()->InsertNextCell(3, ids);
      },
      "has no point " + std::to_string(point) + ", which cell 6 refers to.");
  }
}

void TestMatrices(RelevoCheck& check)
{
  const auto expectError = [&check](int row, int column, double element, const char* words)
  {
    ExpectError(
      check, [=](vtkPolyData*, vtkMatrix4x4* matrix) { matrix->SetElement(row, column, element); },
      words);
  };
  expectError(0, 0, 0.0, "has a singular matrix.");
  expectError(1, 3, NaN, "has a matrix that is not finite.");
  expectError(3, 0, 0.5, "has a matrix that is not affine: its last row is not 0 0 0 1.");
  expectError(2, 3, 1.1e300, "has a matrix that moves points beyond 1e300.");
  expectError(2, 2, 1e305, "has a matrix that moves points beyond 1e300.");
}

void TestSettings(RelevoCheck& check)
{
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  RelevoErrors errors(filter);
  filter->SetContactDistance(-1.0);
  CHECK(errors.Said("ContactDistance must be at least 0 and finite, got -1."));
  CHECK_EQUAL(filter->GetContactDistance(), 0.0);
  vtkNew<vtkMatrix4x4> matrix;
  filter->SetMatrix(2, matrix);
  CHECK(errors.Said("Input must be in [0, 1], got 2."));
  CHECK(!filter->GetMatrix(-1));
  CHECK(errors.Said("Input must be in [0, 1], got -1."));
  filter->SetMatrix(1, matrix);
  CHECK(filter->GetMatrix(1) == matrix && !filter->GetMatrix(0));
  const vtkMTimeType before = filter->GetMTime();
  matrix->SetElement(0, 3, 1.0);
  CHECK_GREATER(filter->GetMTime(), before);
}

void TestFlatTriangles(RelevoCheck& check)
{
  auto box = RelevoMakeBox(0, 1);
  auto other = RelevoMakeBox(0.5, 2);
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, box);
  filter->SetInputData(1, other);
  filter->Update();
  const vtkIdType numberOfLines = filter->GetOutput()->GetNumberOfLines();
  // The mesh has a repeated corner, three collinear points, a coincident point, and a face without
  // area among those of a square.
  other->GetPoints()->InsertNextPoint(1.25, 0.5, 0.5);
  other->GetPoints()->InsertNextPoint(0.5, 0.5, 0.5);
  for (const std::vector<vtkIdType>& ids :
    { std::vector<vtkIdType>{ 0, 0, 1 }, { 0, 8, 1 }, { 0, 9, 3 }, { 0, 8, 1, 3 } })
  {
    other->GetPolys()->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  other->Modified();
  filter->ClassifyOn();
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.Warned("Input 1 has 4 triangles without an area; they are left out."));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), numberOfLines);
  vtkDataArray* distances = filter->GetOutput(3)->GetCellData()->GetArray("Distance");
  CHECK_EQUAL(distances->GetComponent(6, 0), -1.0);
  CHECK_EQUAL(distances->GetComponent(9, 0), 0.0);
  // The mesh has only degenerate faces.
  auto line = RelevoMakePolygons({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } });
  for (int input = 0; input < 2; ++input)
  {
    filter->SetInputData(input, line);
    filter->SetInputData(1 - input, box);
    filter->Update();
    CHECK(errors.Warned("has 1 triangles without an area"));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
    CHECK_EQUAL(filter->GetOutput(2 + input)->GetNumberOfCells(), 1);
  }
  auto point = RelevoMakePolygons({ { 0, 0, 0 } }, { { 0, 0, 0 } });
  filter->SetInputData(0, point);
  filter->Update();
  CHECK(errors.Warned("Input 0 has 1 triangles without an area"));
}

// After an abort, the outputs are empty without an error.
void TestAbort(RelevoCheck& check)
{
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, RelevoMakeBox(0, 1));
  filter->SetInputData(1, RelevoMakeBox(0.5, 2));
  RelevoErrors errors(filter);
  const unsigned long tag = filter->AddObserver(
    vtkCommand::ProgressEvent, filter.Get(), &vtkSurfaceIntersectionFilter::AbortExecuteOn);
  filter->Update();
  CHECK(errors.None() && IsEmpty(filter));
  filter->RemoveObserver(tag);
  filter->AbortExecuteOff();
  filter->Modified();
  filter->Update();
  CHECK(errors.None() && !IsEmpty(filter));
}

// Very large and very small coordinates are exact too.
void TestLargeCoordinates(RelevoCheck& check)
{
  for (double scale : { 1e300, 1.0, 1e-160, 1e-300 })
  {
    CHECK_CASE(scale);
    auto first =
      RelevoMakePolygons({ { 0, 0, 0 }, { scale, 0, 0 }, { 0, scale, 0 } }, { { 0, 1, 2 } });
    auto second =
      RelevoMakePolygons({ { 0.25 * scale, 0.25 * scale, -scale },
                           { 0.25 * scale, 0.25 * scale, scale }, { scale, scale, scale } },
        { { 0, 1, 2 } });
    vtkNew<vtkSurfaceIntersectionFilter> filter;
    filter->SetInputData(0, first);
    filter->SetInputData(1, second);
    RelevoErrors errors(filter);
    filter->Update();
    CHECK(errors.None());
    vtkPolyData* curves = filter->GetOutput();
    CHECK_EQUAL(curves->GetNumberOfLines(), 1);
    CHECK_EQUAL(curves->GetNumberOfPoints(), 2);
    for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
    {
      double x[3];
      curves->GetPoint(i, x);
      CHECK((x[0] == 0.25 * scale || x[0] == 0.5 * scale) && x[1] == x[0] && x[2] == 0.0);
    }
  }
}
}

int TestSurfaceIntersectionErrors(int, char*[])
{
  RelevoCheck check;
  TestMeshes(check);
  TestMatrices(check);
  TestSettings(check);
  TestFlatTriangles(check);
  TestAbort(check);
  TestLargeCoordinates(check);
  return check.GetResult();
}

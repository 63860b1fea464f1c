// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveFilter promises curves of all kinds and degrees at the positions of VTK's cells,
// with their data.
#include "RelevoCheck.h"
#include "RelevoCurves.h"
#include "RelevoPatches.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{
constexpr int Level = 4;

// Compares one line with VTK's formula: positions and "Values".
void TestCell(RelevoCheck& check, vtkUnstructuredGrid* grid)
{
  auto filter = RelevoNewCurveFilter(grid, Level);
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.None());
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfLines(), 1);
  CHECK_EQUAL(output->GetNumberOfCells(), 1);
  const std::vector<RelevoPosition> places = RelevoGetCellPoints(output, 0);
  CHECK_EQUAL(places.size(), (1u << Level) + 1);
  vtkDataArray* given = grid->GetPointData()->GetArray("Values");
  vtkDataArray* values = output->GetPointData()->GetArray("Values");
  CHECK(values && values->GetNumberOfTuples() == output->GetNumberOfPoints());
  vtkCell* cell = grid->GetCell(0);
  const bool isCentered = cell->GetCellType() == VTK_CUBIC_LINE;
  std::vector<double> weights(cell->GetNumberOfPoints());
  for (std::size_t i = 0; values && i < places.size(); ++i)
  {
    const double t = static_cast<double>(i) / (1 << Level);
    const double coordinates[3] = { isCentered ? 2.0 * t - 1.0 : t, 0.0, 0.0 };
    int part = 0;
    RelevoPosition place{};
    cell->EvaluateLocation(part, coordinates, place.data(), weights.data());
    CHECK_NEAR(RelevoGetDistance(place, places[i]), 0.0, 1e-12);
    for (int c = 0; c < given->GetNumberOfComponents(); ++c)
    {
      double sum = 0.0;
      for (vtkIdType n = 0; n < cell->GetNumberOfPoints(); ++n)
      {
        sum += weights[n] * given->GetComponent(cell->GetPointId(n), c);
      }
      vtkNew<vtkIdList> ids;
      output->GetCellPoints(0, ids);
      CHECK_NEAR(values->GetComponent(ids->GetId(static_cast<vtkIdType>(i)), c), sum, 1e-12);
    }
  }
  // Both ends are exact.
  for (int end = 0; end < 2; ++end)
  {
    RelevoPosition node;
    grid->GetPoint(cell->GetPointId(end), node.data());
    CHECK_EQUAL(node, (end == 0 ? places.front() : places.back()));
  }
}

void TestKinds(RelevoCheck& check)
{
  TestCell(check, RelevoNewCell(VTK_LINE, { 1, 0, 0 }, 0.3));
  TestCell(check, RelevoNewCell(VTK_QUADRATIC_EDGE, { 2, 0, 0 }, 0.3));
  TestCell(check, RelevoNewCell(VTK_CUBIC_LINE, { 3, 0, 0 }, 0.3));
  for (int degree = 1; degree <= 8; ++degree)
  {
    TestCell(check, RelevoNewCell(VTK_LAGRANGE_CURVE, { degree, 0, 0 }, 0.2, false, degree + 1));
    TestCell(check, RelevoNewCell(VTK_BEZIER_CURVE, { degree, 0, 0 }, 0.4, false, degree + 1));
    TestCell(check, RelevoNewCell(VTK_BEZIER_CURVE, { degree, 0, 0 }, 0.4, true, degree + 1));
  }
}

// Far from the origin, in floats, ends are exact and other points accurate to a float's rounding.
void TestFloats(RelevoCheck& check)
{
  auto grid = RelevoNewCell(VTK_BEZIER_CURVE, { 3, 0, 0 }, 0.4, true, 4);
  vtkNew<vtkPoints> points; // floats
  for (vtkIdType i = 0; i < 4; ++i)
  {
    RelevoPosition place;
    grid->GetPoint(i, place.data());
    points->InsertNextPoint(place[0] + 1e5, place[1] - 1e5, place[2]);
  }
  grid->SetPoints(points);
  auto filter = RelevoNewCurveFilter(grid, 3);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  const std::vector<RelevoPosition> places = RelevoGetCellPoints(filter->GetOutput(), 0);
  for (int i = 0; i <= 8; ++i)
  {
    CHECK_NEAR(RelevoGetDistance(places[i], RelevoEvaluateCell(grid, 0, i / 8.0, 0.0)), 0.0, 0.008);
  }
  RelevoPosition node;
  grid->GetPoint(1, node.data());
  CHECK_EQUAL(node, places.back());
}

// A NURBS circle is exactly round, and its arcs share their ends.
void TestCircle(RelevoCheck& check)
{
  auto source = RelevoMakeCircle().NewSource();
  source->Update();
  auto filter = RelevoNewCurveFilter(source->GetOutput(), 5);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfLines(), 4);
  CHECK_EQUAL(output->GetNumberOfPoints(), 4 * 32);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    CHECK_NEAR(std::hypot(x[0], x[1]), 1.0, 4e-16);
    CHECK_EQUAL(x[2], 0.0);
  }
}

// Each poly-line gives one line. Segments of zero length are removed, and other cells are not
// curves.
void TestPolyLines(RelevoCheck& check)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i == 3 ? 2.0 : i, i % 2 == 0 || i == 3 ? 0.0 : 1.0, 0.0);
  }
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2, 3, 4 });
  lines->InsertNextCell({ 4, 5 });
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->SetVerts(verts);
  input->SetLines(lines);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  for (int id : { 7, 8, 9 })
  {
    ids->InsertNextValue(id);
  }
  input->GetCellData()->AddArray(ids);
  auto filter = RelevoNewCurveFilter(input, 2);
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.Warned("1 degenerate curves are left out"));
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfCells(), 2);
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  CHECK_EQUAL(RelevoGetCellPoints(output, 0).size(), 3 * 4 + 2); // two points coincide
  CHECK_EQUAL(RelevoGetCellPoints(output, 0).back(), RelevoGetCellPoints(output, 1).front());
  CHECK_EQUAL(output->GetCellData()->GetArray("Ids")->GetComponent(0, 0), 8.0);
  CHECK_EQUAL(output->GetCellData()->GetArray("vtkOriginalCellIds")->GetComponent(1, 0), 2.0);
}

// Integers are rounded, strings come from the nearest node, missing values spread, and ids are
// removed.
void TestData(RelevoCheck& check)
{
  auto grid = RelevoNewGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } } });
  for (std::array<vtkIdType, 2> ids : { std::array<vtkIdType, 2>{ 0, 1 }, { 1, 2 } })
  {
    grid->InsertNextCell(VTK_LINE, 2, ids.data());
  }
  vtkNew<vtkIntArray> integers;
  integers->SetName("Integers");
  vtkNew<vtkStringArray> strings;
  strings->SetName("Strings");
  vtkNew<vtkDoubleArray> gaps;
  gaps->SetName("Gaps");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (int i = 0; i < 3; ++i)
  {
    integers->InsertNextValue(3 * i);
    strings->InsertNextValue(std::string(1, static_cast<char>('a' + i)));
    gaps->InsertNextValue(i == 0 ? std::numeric_limits<double>::quiet_NaN() : i);
    ids->InsertNextValue(i);
  }
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(integers),
         static_cast<vtkAbstractArray*>(strings), static_cast<vtkAbstractArray*>(gaps) })
  {
    grid->GetPointData()->AddArray(array);
  }
  grid->GetPointData()->SetGlobalIds(ids);
  auto filter = RelevoNewCurveFilter(grid, 2);
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  CHECK_EQUAL(data->GetNumberOfArrays(), 3);
  vtkNew<vtkIdList> points;
  filter->GetOutput()->GetCellPoints(0, points);
  const std::array<double, 5> rounded{ 0, 1, 2, 2, 3 };
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("Strings"));
  for (int i = 0; i <= 4; ++i)
  {
    const vtkIdType point = points->GetId(i);
    CHECK_EQUAL(data->GetArray("Integers")->GetComponent(point, 0), rounded[i]);
    CHECK_EQUAL(names->GetValue(point), (i < 2 ? "a" : "b"));
    const double gap = data->GetArray("Gaps")->GetComponent(point, 0);
    CHECK(i == 4 ? gap == 1.0 : std::isnan(gap));
  }
  filter->GetOutput()->GetCellPoints(1, points);
  CHECK_NEAR(data->GetArray("Gaps")->GetComponent(points->GetId(1), 0), 1.25, 1e-15);
}
}

int TestAdaptiveCurveFilter(int, char*[])
{
  RelevoCheck check;
  TestKinds(check);
  TestFloats(check);
  TestCircle(check);
  TestPolyLines(check);
  TestData(check);
  return check.GetResult();
}

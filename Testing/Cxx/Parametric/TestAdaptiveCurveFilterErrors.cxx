// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveFilter promises an error that names cell and array for invalid cells, and the
// other curves.
#include "RelevoCheck.h"
#include "RelevoCurves.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <limits>
#include <numeric>
#include <string>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// Twelve points and a valid line.
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid()
{
  std::vector<RelevoPosition> places;
  for (int i = 0; i < 12; ++i)
  {
    places.push_back({ 1.0 * i, 0.1 * i * i, 0.0 });
  }
  auto grid = RelevoNewGrid(places);
  const std::array<vtkIdType, 2> line{ 10, 11 };
  grid->InsertNextCell(VTK_LINE, 2, line.data());
  return grid;
}

void AddCell(vtkUnstructuredGrid* grid, int type, int number)
{
  std::vector<vtkIdType> ids(number);
  std::iota(ids.begin(), ids.end(), 0);
  grid->InsertNextCell(type, number, ids.data());
}

// Expects one error, and only the valid line in the output.
void ExpectMeshError(RelevoCheck& check, vtkUnstructuredGrid* grid, const char* words)
{
  auto filter = RelevoNewCurveFilter(grid, 2);
  RelevoErrors errors(filter);
  CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
  if (!errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, std::string("no error with: ") + words);
  }
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 5);
}

void ExpectNumber(RelevoCheck& check, int type, int number, const char* words)
{
  auto grid = MakeGrid();
  AddCell(grid, type, number);
  ExpectMeshError(check, grid, words);
}

void TestCells(RelevoCheck& check)
{
  ExpectNumber(check, VTK_LINE, 3, "Cell 1 has 3 points, but needs 2. It is left out.");
  ExpectNumber(check, VTK_POLY_LINE, 1, "Cell 1 has 1 points, but needs 2 or more.");
  ExpectNumber(check, VTK_QUADRATIC_EDGE, 2, "Cell 1 has 2 points, but needs 3.");
  ExpectNumber(check, VTK_CUBIC_LINE, 3, "Cell 1 has 3 points, but needs 4.");
  ExpectNumber(check, VTK_LAGRANGE_CURVE, 1, "Cell 1 has 1 points, but needs 2 or more.");
  ExpectNumber(check, VTK_LAGRANGE_CURVE, 10, "Cell 1 has degree 9, but the highest degree is 8.");
  ExpectNumber(check, VTK_BEZIER_CURVE, 11, "Cell 1 has degree 10, but the highest degree is 8.");
  ExpectNumber(check, VTK_HIGHER_ORDER_EDGE, 3,
    "Cell 1 is a curve of VTK's cell type 60, which is not supported.");

  auto grid = MakeGrid();
  AddCell(grid, VTK_BEZIER_CURVE, 4);
  AddCell(grid, VTK_CUBIC_LINE, 2);
  AddCell(grid, VTK_CUBIC_LINE, 5);
  vtkNew<vtkIntArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  for (int degree : { 0, 2, 0, 0 })
  {
    degrees->InsertNextTuple3(degree, 0, 0);
  }
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  ExpectMeshError(check, grid,
    "Cell 1 has 4 points, but degree 2 in cell array \"HigherOrderDegrees\". It and 2 "
    "more cells are left out.");
}

void TestPoints(RelevoCheck& check)
{
  auto grid = MakeGrid();
  const std::array<vtkIdType, 2> beyond{ 1, 12 };
  grid->InsertNextCell(VTK_LINE, 2, beyond.data());
  ExpectMeshError(check, grid, "Cell 1 refers to point 12, but there are 12 points.");

  grid = MakeGrid();
  AddCell(grid, VTK_QUADRATIC_EDGE, 3);
  grid->GetPoints()->SetPoint(2, 0.0, NaN, 0.0);
  ExpectMeshError(check, grid, "Cell 1 has point 2, which is not finite.");

  for (double weight : { 0.0, -1.0, NaN, std::numeric_limits<double>::infinity() })
  {
    grid = MakeGrid();
    AddCell(grid, VTK_BEZIER_CURVE, 4);
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("RationalWeights");
    weights->SetNumberOfValues(12);
    weights->FillValue(1.0);
    weights->SetValue(3, weight);
    weights->SetValue(10, 0.0); // lines have no weights
    grid->GetPointData()->SetRationalWeights(weights);
    ExpectMeshError(check, grid, "at point 3 in point array \"RationalWeights\"; weights must be");
  }
}

// Expects an empty output.
void ExpectError(RelevoCheck& check, vtkAdaptiveCurveFilter* filter, const char* words)
{
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  CHECK_EQUAL(filter->GetExecutive()->Update(), 0);
  if (!errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, std::string("no error with: ") + words);
  }
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
}

void TestWhole(RelevoCheck& check)
{
  auto grid = MakeGrid();
  auto filter = RelevoNewCurveFilter(grid, 2);
  filter->SetRefinement(nullptr);
  ExpectError(check, filter, "There is no recipe: call SetRefinement()");
  filter = RelevoNewCurveFilter(grid, 2);
  filter->SetRepresentationToRibbons();
  ExpectError(check, filter, "Ribbons need a camera to face: call SetCamera().");
  filter->SetRepresentationToTubes();
  filter->SetRadiusArrayName("Radii");
  ExpectError(check, filter, "Cannot read the radii: point array \"Radii\" does not exist.");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radii");
  radii->SetNumberOfValues(12);
  radii->FillValue(1.0);
  radii->SetValue(7, -0.5);
  grid->GetPointData()->AddArray(radii);
  ExpectError(
    check, filter, "Cannot read the radii: point array \"Radii\" is negative at point 7.");

  vtkNew<vtkUnstructuredGrid> empty;
  ExpectError(check, RelevoNewCurveFilter(empty, 2), "The input has no cells");
  vtkNew<vtkPolyData> nothing;
  ExpectError(check, RelevoNewCurveFilter(nothing, 2), "The input has no cells");
  grid = RelevoNewGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } });
  AddCell(grid, VTK_TRIANGLE, 3);
  ExpectError(check, RelevoNewCurveFilter(grid, 2), "None of the input's cells is a curve.");
}

// Blocks of other types give an error and are skipped.
void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkStructuredGrid>());
  blocks->SetBlock(1, MakeGrid());
  auto filter = RelevoNewCurveFilter(MakeGrid(), 2);
  filter->SetInputDataObject(blocks);
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  filter->Update();
  CHECK(errors.Said(
    "The input is a vtkStructuredGrid; a vtkUnstructuredGrid or a vtkPolyData is needed."));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* second = output ? vtkPolyData::SafeDownCast(output->GetBlock(1)) : nullptr;
  CHECK(second && second->GetNumberOfLines() == 1);
}

// Cells that another piece draws and curves without length are not errors.
void TestLeftOut(RelevoCheck& check)
{
  auto grid = MakeGrid();
  AddCell(grid, VTK_CUBIC_LINE, 4);
  AddCell(grid, VTK_CUBIC_LINE, 2); // invalid, but hidden
  const std::array<vtkIdType, 3> same{ 5, 5, 5 };
  grid->InsertNextCell(VTK_QUADRATIC_EDGE, 3, same.data());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int type : { 0, static_cast<int>(vtkDataSetAttributes::DUPLICATECELL),
         static_cast<int>(vtkDataSetAttributes::HIDDENCELL), 0 })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(type));
  }
  grid->GetCellData()->AddArray(ghosts);
  auto filter = RelevoNewCurveFilter(grid, 2);
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.Warned("1 degenerate curves are left out: all their control points coincide."));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1);
}
}

int TestAdaptiveCurveFilterErrors(int, char*[])
{
  RelevoCheck check;
  TestCells(check);
  TestPoints(check);
  TestWhole(check);
  TestBlocks(check);
  TestLeftOut(check);
  return check.GetResult();
}

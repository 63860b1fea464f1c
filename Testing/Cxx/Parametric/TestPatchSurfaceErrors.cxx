// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurfaceFilter promises an error that names the cell and the cause for each invalid cell,
// and outputs the others.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
// Two adjacent Bézier quadrilaterals of degrees 2 and 1. A test makes the second one invalid.
struct Pair
{
  Pair()
  {
    this->Points->SetDataTypeToDouble();
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 5; ++i)
      {
        this->Points->InsertNextPoint(i, j, 0.1 * (i % 2));
        this->Weights->InsertNextValue(1.0);
      }
    }
    this->Grid->SetPoints(this->Points);
    this->Weights->SetName("RationalWeights");
    this->Grid->GetPointData()->SetRationalWeights(this->Weights);
    this->Degrees->SetName("HigherOrderDegrees");
    this->Degrees->SetNumberOfComponents(3);
    this->Grid->GetCellData()->SetHigherOrderDegrees(this->Degrees);
    this->Grid->Allocate(2);
    this->Add(VTK_BEZIER_QUADRILATERAL, { 0, 2, 7, 5, 1, 6 });
  }

  void Add(int type, const std::vector<vtkIdType>& ids, int p = 2, int q = 1)
  {
    this->Grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    this->Degrees->InsertNextTuple3(p, q, 0);
  }

  void AddGood() { this->Add(VTK_BEZIER_QUADRILATERAL, { 2, 4, 9, 7, 3, 8 }); }

  // Expects one patch and one error.
  void Expect(RelevoCheck& check, const std::string& words, int patches = 1)
  {
    vtkNew<vtkPatchSurfaceFilter> filter;
    RelevoErrors errors(filter);
    filter->SetInputData(this->Grid);
    filter->Update();
    CHECK_EQUAL(RelevoGetNumberOfPatches(filter->GetOutput()), patches);
    if (!errors.Said(words))
    {
      check.Fail(__FILE__, __LINE__, "no error with: " + words);
    }
    CHECK(errors.None());
  }

  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Weights;
  vtkNew<vtkIntArray> Degrees;
};

void TestCells(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pair type;
  type.Add(VTK_QUADRATIC_POLYGON, { 2, 4, 9, 7, 3, 8 });
  type.Expect(check, "Cell 1 (vtkQuadraticPolygon, type 36) is left out: cells of this type");
  Pair number;
  number.Add(VTK_BEZIER_QUADRILATERAL, { 2, 4, 9, 7, 3 });
  number.Expect(check,
    "Cell 1 (vtkBezierQuadrilateral, type 77) is left out: a cell of this type "
    "cannot have 5 nodes with the degrees 2, 1, 0 of \"HigherOrderDegrees\".");
  Pair few;
  few.Add(VTK_HEXAHEDRON, { 0, 1, 2, 3 });
  few.Expect(check, "a cell of this type cannot have 4 nodes.");
  Pair line;
  line.Add(VTK_POLYGON, { 0, 1 });
  line.Expect(
    check, "Cell 1 (vtkPolygon, type 7) is left out: a cell of this type cannot have 2 nodes");
  Pair degree;
  degree.Add(VTK_BEZIER_QUADRILATERAL, { 2, 4, 9, 7, 3, 8 }, 9, 1);
  degree.Expect(check,
    "its degrees are 9, 1, 0 in \"HigherOrderDegrees\", but degrees must be whole numbers from 1 "
    "to 8.");
  Pair none;
  none.Add(VTK_BEZIER_QUADRILATERAL, { 2, 4, 9, 7, 3, 8 }, 0, 0);
  none.Expect(check, "Cell 1");
  // Degrees that do not fit the cell or are not whole numbers from 1 to 8.
  for (double bad : { -1.0, 1e6, 2.5, nan, std::numeric_limits<double>::infinity() })
  {
    CHECK_CASE(bad);
    Pair strange;
    strange.AddGood();
    vtkNew<vtkDoubleArray> degrees;
    degrees->SetName("HigherOrderDegrees");
    degrees->SetNumberOfComponents(3);
    degrees->InsertNextTuple3(2.0, 1.0, 0.0);
    degrees->InsertNextTuple3(bad, 1.0, 0.0);
    strange.Grid->GetCellData()->SetHigherOrderDegrees(degrees);
    strange.Expect(
      check, " in \"HigherOrderDegrees\", but degrees must be whole numbers from 1 to 8.");
    degrees->SetNumberOfTuples(1);
    strange.Expect(check, "\"HigherOrderDegrees\" has no tuple of 3 numbers for it.");
  }
  Pair simplex;
  simplex.Add(VTK_LAGRANGE_TRIANGLE, { 2, 4, 9, 3, 8, 7 }, 3, 3);
  simplex.Expect(
    check, "its degrees are 3, 3, 0 in \"HigherOrderDegrees\", but its 6 nodes need degree 2.");
  Pair thin;
  thin.Add(VTK_LINE, { 2, 10 });
  thin.Expect(
    check, "Cell 1 (vtkLine, type 3) is left out: it refers to point 10, but there are 10 points.");
  Pair outside;
  outside.Add(VTK_TRIANGLE, { 2, 4, 10 });
  outside.Expect(check, "it refers to point 10, but there are 10 points.");
  for (double bad : { nan, std::numeric_limits<double>::infinity() })
  {
    CHECK_CASE(bad);
    Pair point;
    point.AddGood();
    point.Points->SetPoint(8, 0.0, bad, 0.0);
    point.Expect(check, "Cell 1 (vtkBezierQuadrilateral, type 77) is left out: point 8 is not");
  }
  for (double bad : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    CHECK_CASE(bad);
    Pair weight;
    weight.AddGood();
    weight.Weights->SetValue(3, bad);
    weight.Expect(check, "point 3 has the weight ");
  }
  Pair missing;
  missing.AddGood();
  missing.Weights->SetNumberOfTuples(9);
  vtkNew<vtkPatchSurfaceFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(missing.Grid);
  filter->Update();
  CHECK(errors.Said("point 9 has no weight in \"RationalWeights\"."));
  CHECK_EQUAL(RelevoGetNumberOfPatches(filter->GetOutput()), 1);
}

// Cells with damaged lists.
void TestLists(RelevoCheck& check)
{
  const std::array<vtkIdType, 4> ids{ 2, 4, 9, 7 };
  for (vtkIdType last : { 99, -1 })
  {
    CHECK_CASE(last);
    Pair strange;
    const std::array<vtkIdType, 16> faces{ 3, 2, 4, 9, 3, 2, 9, 7, 3, 2, 7, 4, 3, 4, 9, last };
    strange.Grid->InsertNextCell(VTK_POLYHEDRON, 4, ids.data(), 4, faces.data());
    strange.Expect(
      check, "it refers to point " + std::to_string(last) + ", but there are 10 points.");
  }
  Pair thin;
  const std::array<vtkIdType, 7> faces{ 3, 2, 4, 9, 2, 2, 9 };
  thin.Grid->InsertNextCell(VTK_POLYHEDRON, 4, ids.data(), 2, faces.data());
  thin.Expect(check, "its list of faces is incomplete, or has a face with fewer than 3 points.");
  // A face with a point of another cell, a cell without faces, and a face list that is missing.
  Pair foreign;
  const std::array<vtkIdType, 16> others{ 3, 2, 4, 9, 3, 2, 9, 7, 3, 2, 7, 4, 3, 4, 9, 0 };
  foreign.Grid->InsertNextCell(VTK_POLYHEDRON, 4, ids.data(), 4, others.data());
  foreign.Expect(check, "point 0 of a face is not in the cell's list of points.");
  Pair open;
  open.Grid->InsertNextCell(VTK_POLYHEDRON, 4, ids.data(), 0, others.data());
  open.Expect(check, "its list of faces is incomplete");
  // Offsets decrease, and types are too few.
  for (double offset : { 3.0, -1.0, 1e12 })
  {
    CHECK_CASE(offset);
    Pair list;
    list.AddGood();
    list.Grid->GetCells()->GetOffsetsArray()->SetComponent(2, 0, offset);
    list.Expect(
      check, "Cell 1 is left out: the grid's arrays of cell types, offsets and point ids");
  }
  Pair few;
  few.AddGood();
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(VTK_BEZIER_QUADRILATERAL);
  const vtkSmartPointer<vtkCellArray> cells = few.Grid->GetCells();
  few.Grid->SetCells(types, cells);
  few.Expect(check, "Cell 1 is left out: the grid's arrays of cell types, offsets and point ids");
  // A single node does not define a degree.
  for (int type : { VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_QUADRILATERAL, VTK_LAGRANGE_WEDGE })
  {
    CHECK_CASE(type);
    Pair single;
    single.Add(type, { 2 }, 0, 0);
    single.Expect(check, "its degrees are 0, 0, 0 in \"HigherOrderDegrees\"");
  }
  for (int type : { VTK_VERTEX, VTK_TRIANGLE })
  {
    vtkNew<vtkUnstructuredGrid> grid; // has no points
    grid->Allocate(1);
    grid->InsertNextCell(type, type == VTK_VERTEX ? 1 : 3, ids.data());
    vtkNew<vtkPatchSurfaceFilter> filter;
    RelevoErrors errors(filter);
    filter->SetInputData(grid);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
    CHECK(errors.Said("it refers to point 2, but there are 0 points."));
    CHECK(errors.None());
  }
}

// Many invalid cells give one error per cause.
void TestMany(RelevoCheck& check)
{
  Pair pair;
  for (int i = 0; i < 1000; ++i)
  {
    pair.Add(VTK_LAGRANGE_PYRAMID, { 0, 1, 6, 5, 9 });
  }
  pair.AddGood();
  pair.Expect(check, "Cell 1 (type 74) is left out: cells of this type are not", 2);
  pair.Expect(check, "999 more cells have the same fault.", 2);
}

void TestWarnings(RelevoCheck& check)
{
  Pair pair;
  pair.Add(VTK_TRIANGLE, { 0, 2, 4 }); // collinear
  pair.Add(VTK_QUAD, { 3, 3, 3, 3 });
  vtkNew<vtkDoubleArray> few;
  few->SetName("Few");
  few->InsertNextValue(1.0);
  pair.Grid->GetPointData()->AddArray(few);
  vtkNew<vtkPatchSurfaceFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(pair.Grid);
  filter->Update();
  CHECK(errors.Warned("Array \"Few\" has too few tuples and is left out."));
  CHECK_EQUAL(RelevoGetNumberOfPatches(filter->GetOutput()), 1);
  CHECK(!filter->GetOutput()->GetPointData()->GetArray("Few"));
  CHECK(pair.Grid->GetPointData()->GetArray("Few"));
  pair.Grid->GetPointData()->RemoveArray("Few");
  filter->Modified();
  filter->Update();
  CHECK(errors.Warned("2 degenerate patches without any area are left out."));
  CHECK(errors.None());
}

// A block of another type does not affect the other blocks.
void TestBlocks(RelevoCheck& check)
{
  Pair pair;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, pair.Grid);
  vtkNew<vtkPatchSurfaceFilter> filter;
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  filter->SetInputDataObject(blocks);
  filter->Update();
  CHECK(errors.Said("The input is a vtkPolyData; a vtkUnstructuredGrid is needed."));
  CHECK(errors.None());
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* last = output ? vtkPolyData::SafeDownCast(output->GetBlock(2)) : nullptr;
  CHECK(last && RelevoGetNumberOfPatches(last) == 1);
}

// Points, lines and empty grids are not errors.
void TestThin(RelevoCheck& check)
{
  Pair pair;
  pair.Add(VTK_LINE, { 0, 1 });
  pair.Add(VTK_VERTEX, { 0 });
  pair.Add(VTK_LAGRANGE_CURVE, { 0, 1, 2 });
  vtkNew<vtkPatchSurfaceFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(pair.Grid);
  filter->Update();
  CHECK_EQUAL(RelevoGetNumberOfPatches(filter->GetOutput()), 1);
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputData(empty);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK(errors.None());
}

// Ghost cells stay ghost cells. Hidden cells expose the faces behind them.
void TestGhosts(RelevoCheck& check)
{
  auto grid = RelevoNewCell(VTK_HEXAHEDRON, { 1, 1, 1 }, 0.0);
  std::array<vtkIdType, 8> ids{ 1, 8, 9, 2, 5, 10, 11, 6 };
  for (double z : { 0.0, 1.0 })
  {
    grid->GetPoints()->InsertNextPoint(2.0, 0.0, z);
    grid->GetPoints()->InsertNextPoint(2.0, 1.0, z);
  }
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
  grid->GetPointData()->Initialize();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  types->InsertNextValue(0);
  types->InsertNextValue(vtkDataSetAttributes::DUPLICATECELL);
  grid->GetCellData()->AddArray(types);
  auto mesh = RelevoMakePatches(grid);
  CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), 10);
  vtkDataArray* ghosts = mesh->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  vtkDataArray* cells = mesh->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    CHECK(ghosts && ghosts->GetTuple1(i) == cells->GetTuple1(i));
  }
  types->SetValue(1, vtkDataSetAttributes::HIDDENCELL);
  types->Modified();
  grid->Modified();
  CHECK_EQUAL(RelevoGetNumberOfPatches(RelevoMakePatches(grid)), 6);
}
}

int TestPatchSurfaceErrors(int, char*[])
{
  RelevoCheck check;
  TestCells(check);
  TestLists(check);
  TestMany(check);
  TestWarnings(check);
  TestBlocks(check);
  TestThin(check);
  TestGhosts(check);
  return check.GetResult();
}

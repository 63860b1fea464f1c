// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCurvedFaceFilter promises 2D cells with the patches of the grid, their points and ids, and the
// errors of vtkPatchSurfaceFilter.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCurvedFaceFilter.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
// The tuples of the control points of a patch: type, degrees, points and values.
using PatchTuples = std::vector<double>;

std::vector<PatchTuples> ReadPatches(vtkPolyData* mesh)
{
  vtkFieldData* data = mesh->GetFieldData();
  vtkDataArray* table = data->GetArray("Patches");
  vtkDataArray* points = data->GetArray("PatchPoints");
  vtkDataArray* values = data->GetArray("PatchNodes:Values");
  std::vector<PatchTuples> patches;
  for (vtkIdType i = 0; table && i < table->GetNumberOfTuples(); ++i)
  {
    const bool isLast = i + 1 == table->GetNumberOfTuples();
    const double end =
      isLast ? static_cast<double>(points->GetNumberOfTuples()) : table->GetComponent(i + 1, 3);
    PatchTuples patch{ table->GetComponent(i, 0), table->GetComponent(i, 1),
      table->GetComponent(i, 2) };
    for (auto k = static_cast<vtkIdType>(table->GetComponent(i, 3)); k < end; ++k)
    {
      for (vtkDataArray* array : { points, values })
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          patch.push_back(array->GetComponent(k, c));
        }
      }
    }
    patches.push_back(patch);
  }
  std::sort(patches.begin(), patches.end()); // prisms have their polygons first
  return patches;
}

void TestCell(RelevoCheck& check, vtkUnstructuredGrid* grid)
{
  CHECK_CASE(grid->GetCellType(0));
  vtkNew<vtkCurvedFaceFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(grid);
  filter->Update();
  CHECK(errors.None());
  vtkUnstructuredGrid* faces = filter->GetOutput();
  const std::vector<PatchTuples> expected = ReadPatches(RelevoMakePatches(grid));
  const std::vector<PatchTuples> found = ReadPatches(RelevoMakePatches(faces));
  CHECK_EQUAL(found.size(), expected.size());
  CHECK(!found.empty() && found == expected); // to the bit

  vtkDataArray* points = faces->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* values = faces->GetPointData()->GetArray("Values");
  vtkDataArray* given = grid->GetPointData()->GetArray("Values");
  bool areSame = points && values && faces->GetNumberOfPoints() <= grid->GetNumberOfPoints();
  for (vtkIdType i = 0; areSame && i < faces->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(points->GetComponent(i, 0));
    double own[3];
    double original[3];
    faces->GetPoint(i, own);
    grid->GetPoint(id, original);
    areSame = std::equal(own, own + 3, original) &&
      values->GetComponent(i, 1) == given->GetComponent(id, 1);
  }
  CHECK(areSame);
  vtkDataArray* cells = faces->GetCellData()->GetArray("vtkOriginalCellIds");
  CHECK(cells && cells->GetRange()[0] == 0.0 && cells->GetRange()[1] == 0.0);
}

void TestCells(RelevoCheck& check)
{
  for (int type :
    { VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID,
      VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_TRIANGLE,
      VTK_QUADRATIC_LINEAR_QUAD, VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_TETRA,
      VTK_QUADRATIC_HEXAHEDRON, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_HEXAHEDRON,
      VTK_QUADRATIC_LINEAR_WEDGE, VTK_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
      VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_PYRAMID })
  {
    TestCell(check, RelevoNewCell(type, { 2, 2, 2 }, 0.1));
  }
  for (int p = 1; p <= 8; ++p)
  {
    const int q = (3 * p) % 8 + 1;
    const int r = (5 * p + 2) % 8 + 1;
    for (int first : { VTK_LAGRANGE_CURVE, VTK_BEZIER_CURVE })
    {
      const bool isRational = first == VTK_BEZIER_CURVE;
      const double share = 0.2 / p;
      TestCell(check, RelevoNewCell(first + 1, { p, p, p }, share, isRational));
      TestCell(check, RelevoNewCell(first + 2, { p, q, 0 }, share, isRational));
      TestCell(check, RelevoNewCell(first + 3, { p, p, p }, share, isRational));
      TestCell(check, RelevoNewCell(first + 4, { p, q, r }, share, isRational));
      TestCell(check, RelevoNewCell(first + 5, { p, p, q }, share, isRational));
    }
  }
}

// Only the outer faces of several cells remain.
void TestOuterFaces(RelevoCheck& check)
{
  const auto bracket = RelevoNewBracket(0.1);
  vtkNew<vtkCurvedFaceFilter> filter;
  filter->SetInputData(bracket);
  filter->Update();
  vtkUnstructuredGrid* faces = filter->GetOutput();
  CHECK_LESS(faces->GetNumberOfPoints(), bracket->GetNumberOfPoints());
  CHECK_EQUAL(faces->GetNumberOfCells(),
    static_cast<vtkIdType>(RelevoGetNumberOfPatches(RelevoMakePatches(bracket))));
  vtkDataArray* ids = faces->GetCellData()->GetArray("vtkOriginalCellIds");
  CHECK_LESS(ids->GetRange()[1], static_cast<double>(bracket->GetNumberOfCells()));
  CHECK_LESS(0.0, ids->GetRange()[1]);
}

void TestErrors(RelevoCheck& check)
{
  const auto grid = RelevoNewCell(VTK_QUADRATIC_QUAD, { 2, 2, 2 }, 0.1);
  grid->GetPoints()->SetPoint(1, std::nan(""), 0.0, 0.0);
  vtkNew<vtkIntArray> array;
  array->SetName("Short");
  array->InsertNextValue(1);
  grid->GetPointData()->AddArray(array);
  vtkNew<vtkCurvedFaceFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(grid);
  filter->Update();
  CHECK(errors.Said("not finite"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK(!filter->GetOutput()->GetPointData()->HasArray("Short"));
}
}

int TestCurvedFaceFilter(int, char*[])
{
  RelevoCheck check;
  TestCells(check);
  TestOuterFaces(check);
  TestErrors(check);
  return check.GetResult();
}

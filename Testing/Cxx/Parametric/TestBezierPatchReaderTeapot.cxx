// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkBezierPatchReader promises the 32 patches of the Utah teapot as in the file, with shared
// borders.
#include "RelevoCheck.h"
#include "RelevoPatchFiles.h"

#include "vtkBezierPatchReader.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkUnstructuredGrid.h"

#include <fstream>
#include <iostream>

namespace
{
// Volume of the patches by Gauss's theorem. It is negative if normals point inwards.
double GetVolume(vtkUnstructuredGrid* grid)
{
  constexpr int steps = 20;
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    for (int k = 0; k < steps * steps; ++k)
    {
      const double u = (k % steps) / static_cast<double>(steps);
      const double v = (k / steps) / static_cast<double>(steps);
      const RelevoPosition a = RelevoEvaluateCell(grid, cell, u, v);
      const RelevoPosition b = RelevoEvaluateCell(grid, cell, u + 1.0 / steps, v);
      const RelevoPosition c = RelevoEvaluateCell(grid, cell, u, v + 1.0 / steps);
      const RelevoPosition d = RelevoEvaluateCell(grid, cell, u + 1.0 / steps, v + 1.0 / steps);
      sum += vtkMath::Determinant3x3(a.data(), b.data(), d.data()) / 6.0;
      sum += vtkMath::Determinant3x3(a.data(), d.data(), c.data()) / 6.0;
    }
  }
  return sum;
}
}

int TestBezierPatchReaderTeapot(int, char*[])
{
  RelevoCheck check;
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string name = std::string(data ? data : "") + "/mesh/teapot.bpt";
  std::ifstream file(name);
  if (!file)
  {
    std::cerr << "RELEVO_TEST_DATA has no mesh/teapot.bpt: skipped\n";
    return 125;
  }
  vtkNew<vtkBezierPatchReader> reader;
  RelevoErrors errors(reader);
  CHECK_EQUAL(reader->CanReadFile(name.c_str()), 1);
  reader->SetFileName(name.c_str());
  reader->Update();
  CHECK(errors.None());
  vtkUnstructuredGrid* grid = reader->GetOutput();
  CHECK_EQUAL(grid->GetNumberOfCells(), 32);
  CHECK_EQUAL(grid->GetCellData()->GetHigherOrderDegrees()->GetRange(0)[0], 3.0);
  CHECK_NEAR(RelevoGetPatchError(grid, RelevoReadPatches(file)), 0.0, 1e-14);
  CHECK_EQUAL(grid->GetNumberOfPoints(), 298); // instead of 512
  CHECK_GREATER(GetVolume(grid), 20.0);        // all normals point outwards
  return check.GetResult();
}

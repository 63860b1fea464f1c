// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The Utah teapot: its 32 patches as they are in the file, with their borders in common.
#include "RelevoCheck.h"
#include "RelevoPatchFiles.h"

#include "vtkBezierPatchReader.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <fstream>
#include <iostream>

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
  CHECK(reader->CanReadFile(name.c_str()) == 1);
  reader->SetFileName(name.c_str());
  reader->Update();
  CHECK(errors.None());
  vtkUnstructuredGrid* grid = reader->GetOutput();
  CHECK(grid->GetNumberOfCells() == 32);
  CHECK(grid->GetCellData()->GetHigherOrderDegrees()->GetRange(0)[0] == 3.0);
  CHECK_NEAR(RelevoGetPatchError(grid, RelevoReadPatches(file)), 0.0, 1e-14);
  CHECK(grid->GetNumberOfPoints() < 512 - 100);
  std::cout << grid->GetNumberOfPoints() << " points\n";
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that sources, filters and readers report an error with an empty output if memory runs out,
// and work again afterwards.
#include "RelevoCheck.h"
#include "RelevoMemory.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBezierPatchReader.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNURBSSource.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <cstdio>
#include <fstream>

namespace
{
constexpr long Megabyte = 1 << 20;

void ExpectError(RelevoCheck& check, vtkAlgorithm* algorithm, const char* words)
{
  const auto count = [&]
  { return vtkPointSet::SafeDownCast(algorithm->GetOutputDataObject(0))->GetNumberOfPoints(); };
  for (long megabytes : { 1, 3 })
  {
    RelevoErrors errors(algorithm);
    RelevoErrors executiveErrors(algorithm->GetExecutive());
    algorithm->Modified();
    {
      const RelevoMemoryLimit limit(megabytes * Megabyte);
      algorithm->Update();
    }
    CHECK(errors.Said(words));
    CHECK_EQUAL(count(), 0);
  }
  algorithm->Modified();
  algorithm->Update();
  CHECK_GREATER(count(), 0);
}

// n x n adjacent cells.
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int n, bool areLines)
{
  vtkNew<vtkPoints> points;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->Allocate(n * n);
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const vtkIdType point = points->InsertNextPoint(i, j, 0.1 * ((i * j) % 3));
      if (i < n && j < n)
      {
        const vtkIdType ids[4] = { point, point + 1, point + n + 2, point + n + 1 };
        grid->InsertNextCell(areLines ? VTK_LINE : VTK_QUAD, areLines ? 2 : 4, ids);
      }
    }
  }
  return grid;
}

void TestFilters(RelevoCheck& check)
{
  vtkNew<vtkPatchSurfaceFilter> patches;
  patches->SetInputData(MakeGrid(120, false));
  ExpectError(check, patches, "Not enough memory for the patches of the grid.");
  vtkNew<vtkAdaptiveCurveFilter> curves;
  curves->SetInputData(MakeGrid(200, true));
  curves->SetRefinement(vtkNew<vtkAdaptiveRefinement>());
  ExpectError(check, curves, "Not enough memory for ");
}

void TestSource(RelevoCheck& check)
{
  constexpr int n = 160;
  vtkNew<vtkNURBSSource> source;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < n * n; ++i)
  {
    points->InsertNextPoint(i % n, i / n, i % 3);
  }
  vtkNew<vtkDoubleArray> knots;
  for (int i = 0; i < n + 4; ++i)
  {
    knots->InsertNextValue(i);
  }
  source->SetDegree(0, 3);
  source->SetDegree(1, 3);
  source->SetDimensions(n, n);
  source->SetControlPoints(points);
  source->SetKnots(0, knots);
  source->SetKnots(1, knots);
  ExpectError(check, source, "Not enough memory for the control points.");
}

[[maybe_unused]] void TestReader(RelevoCheck& check)
{
  const char* name = "TestPatchesOutOfMemory.bpt";
  constexpr int n = 4000;
  {
    std::ofstream file(name);
    file << n << "\n";
    for (int patch = 0; patch < n; ++patch)
    {
      file << "3 3\n";
      for (int i = 0; i < 16; ++i)
      {
        file << patch + i % 4 << " " << i / 4 << " " << i % 3 << "\n";
      }
    }
  }
  vtkNew<vtkBezierPatchReader> reader;
  reader->SetFileName(name);
  ExpectError(check, reader, "Not enough memory for the patches of the file.");
  std::remove(name);
}
}

int TestPatchesOutOfMemory(int, char*[])
{
  if (!RelevoMemoryLimit::Works())
  {
    return 125;
  }
  RelevoCheck check;
  vtkSMPTools::SetBackend("Sequential"); // threads need memory for their stacks
  TestFilters(check);
  TestSource(check);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)
  TestReader(check); // Debian's VTK 9.6 ends the process where an array cannot grow
#endif
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPatchMeshes.h"

#include "RelevoSplines.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkBezierPatchReader.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

namespace
{
constexpr int Degree = 3;

// Deforms the cube of -1 to 1: twisted, with waves three cells long.
std::array<double, 3> Bend(const std::array<double, 3>& x, int side)
{
  const double cell = 2.0 / side;
  const double wave = 2.0 * vtkMath::Pi() / (3.0 * cell);
  std::array<double, 3> bent;
  for (int c = 0; c < 3; ++c)
  {
    bent[c] =
      x[c] + 0.15 * cell * std::sin(wave * x[(c + 1) % 3]) * std::cos(wave * x[(c + 2) % 3]);
  }
  const double angle = 0.4 * bent[2];
  return { { std::cos(angle) * bent[0] - std::sin(angle) * bent[1],
    std::sin(angle) * bent[0] + std::cos(angle) * bent[1], bent[2] } };
}
}

vtkSmartPointer<vtkUnstructuredGrid> BenchmarkPatchMeshes::MakeTeapot()
{
  const char* folder = std::getenv("RELEVO_TEST_DATA");
  const std::string fileName = std::string(folder ? folder : ".") + "/mesh/teapot.bpt";
  if (!std::ifstream(fileName))
  {
    const auto torus = RelevoMakeTorus(1.0, 0.4).NewSource();
    torus->Update();
    return torus->GetOutput();
  }
  vtkNew<vtkBezierPatchReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> BenchmarkPatchMeshes::MakeHexahedra(int side)
{
  const int nodes = Degree * side + 1; // along an edge of the cube
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (int k = 0; k < nodes; ++k)
  {
    for (int j = 0; j < nodes; ++j)
    {
      for (int i = 0; i < nodes; ++i)
      {
        const double step = 2.0 / (nodes - 1);
        const auto x = Bend({ { i * step - 1.0, j * step - 1.0, k * step - 1.0 } }, side);
        points->InsertNextPoint(x.data());
        values->InsertNextValue(
          std::sin(5.0 * x[0]) + std::cos(4.0 * x[1] + 1.0) + std::sin(3.0 * x[2] * x[0]));
      }
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
  const int order[3] = { Degree, Degree, Degree };
  std::array<vtkIdType, (Degree + 1) * (Degree + 1) * (Degree + 1)> ids;
  grid->AllocateExact(static_cast<vtkIdType>(side) * side * side, ids.size());
  for (int cell = 0; cell < side * side * side; ++cell)
  {
    const int first[3] = { Degree * (cell % side), Degree * (cell / side % side),
      Degree * (cell / (side * side)) };
    for (int k = 0; k <= Degree; ++k)
    {
      for (int j = 0; j <= Degree; ++j)
      {
        for (int i = 0; i <= Degree; ++i)
        {
          ids[vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, order)] =
            (static_cast<vtkIdType>(first[2] + k) * nodes + first[1] + j) * nodes + first[0] + i;
        }
      }
    }
    grid->InsertNextCell(VTK_LAGRANGE_HEXAHEDRON, ids.size(), ids.data());
  }
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> BenchmarkPatchMeshes::Part(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto parted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  parted->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> all;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      all->InsertNextId(ids->GetId(i));
      ids->SetId(i, points->InsertNextPoint(grid->GetPoint(ids->GetId(i))));
    }
    parted->InsertNextCell(grid->GetCellType(cell), ids);
  }
  parted->SetPoints(points);
  parted->GetPointData()->CopyAllOn(); // weights are an attribute
  parted->GetPointData()->CopyAllocate(grid->GetPointData(), all->GetNumberOfIds());
  for (vtkIdType i = 0; i < all->GetNumberOfIds(); ++i)
  {
    parted->GetPointData()->CopyData(grid->GetPointData(), all->GetId(i), i);
  }
  parted->GetCellData()->ShallowCopy(grid->GetCellData());
  return parted;
}

vtkSmartPointer<vtkPolyData> BenchmarkPatchMeshes::MakePatches(
  vtkUnstructuredGrid* grid, bool split)
{
  vtkNew<vtkPatchSurfaceFilter> filter;
  filter->SetSplitPatches(split);
  filter->SetInputData(grid);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> BenchmarkPatchMeshes::MakeEvenSurface(
  vtkUnstructuredGrid* grid, int level)
{
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(grid);
  filter->SetNonlinearSubdivisionLevel(level);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkAdaptiveRefinement> BenchmarkPatchMeshes::MakeRecipe(double pixels)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  vtkNew<vtkPatchErrorDepthTagMetric> metric;
  metric->SetScreenSpaceError(pixels);
  recipe->SetMetric(metric);
  recipe->SetLevelRuleToPerEdge();
  recipe->SetMaximumLevel(7);
  recipe->SetSegmentPolicyToWholeNumbers();
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  return recipe;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPatchWay.h"

#include "BenchmarkPatchMeshes.h"
#include "BenchmarkStaticMapper.h"

#include "vtkAdaptivePatchMapper.h"
#include "vtkAdaptiveRefinement.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

BenchmarkPatchWay::BenchmarkPatchWay(Kind kind, vtkUnstructuredGrid* grid)
{
  if (kind == Even)
  {
    this->Mesh = BenchmarkPatchMeshes::MakeEvenSurface(grid, EvenLevel);
    vtkNew<BenchmarkStaticMapper> mapper;
    mapper->SetInputData(this->Mesh);
    this->Mapper = mapper;
  }
  else
  {
    this->Mesh = BenchmarkPatchMeshes::MakePatches(grid);
    vtkNew<vtkAdaptivePatchMapper> mapper;
    mapper->SetInputData(this->Mesh);
    mapper->SetRefinement(BenchmarkPatchMeshes::MakeRecipe(0.5));
    mapper->SetExactScalars(kind == Exact);
    this->Mapper = mapper;
  }
  // Steps between colours are at most 1/255.
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(1024);
  this->Mapper->SetLookupTable(table);
  this->Mapper->SetScalarRange(grid->GetPointData()->GetScalars()->GetRange());
}

BenchmarkPatchWay::~BenchmarkPatchWay() = default;

std::string BenchmarkPatchWay::GetName(Kind kind)
{
  return kind == Even ? "level 4, `vtkPolyDataMapper`"
    : kind == Exact   ? "patches, exact scalars"
                      : "patches, linear scalars";
}

double BenchmarkPatchWay::GetNumberOfTriangles() const
{
  auto* patches = vtkAdaptivePatchMapper::SafeDownCast(this->Mapper);
  return static_cast<double>(
    patches ? patches->GetNumberOfDrawnTriangles() : this->Mesh->GetNumberOfPolys());
}

double BenchmarkPatchWay::GetMemorySize() const
{
  auto* patches = vtkAdaptivePatchMapper::SafeDownCast(this->Mapper);
  const double buffers = patches
    ? static_cast<double>(patches->GetGraphicsMemorySize())
    : BenchmarkStaticMapper::SafeDownCast(this->Mapper)->GetGraphicsMemorySize();
  return 1024.0 * static_cast<double>(this->Mesh->GetActualMemorySize()) + buffers;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SurfaceExtractor.h"

#include "Text/ViewerMessages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <cstring>

namespace
{
const char* const PointIds = "vtkOriginalPointIds";
const char* const CellIds = "vtkOriginalCellIds";

bool AreSame(vtkDataArray* a, vtkDataArray* b)
{
  if (a == b)
  {
    return true;
  }
  const bool isAlike = a && b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfValues() == b->GetNumberOfValues() && a->HasStandardMemoryLayout() &&
    b->HasStandardMemoryLayout();
  return isAlike &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

vtkDataArray* GetTypes(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

// Whether both grids have the same points and cells. Polyhedra and hidden cells count as different.
bool HaveSameCells(vtkDataSet* first, vtkDataSet* second)
{
  auto* a = vtkUnstructuredGrid::SafeDownCast(first);
  auto* b = vtkUnstructuredGrid::SafeDownCast(second);
  if (!a || !b || !a->GetPoints() || !b->GetPoints())
  {
    return false;
  }
  for (vtkUnstructuredGrid* grid : { a, b })
  {
    if (grid->GetCellGhostArray() || grid->GetPointGhostArray())
    {
      return false;
    }
  }
  const auto isPolyhedron = [](vtkDataArray* types, vtkIdType i)
  { return types->GetComponent(i, 0) == VTK_POLYHEDRON; };
  vtkDataArray* types = GetTypes(a);
  if (!types || !AreSame(types, GetTypes(b)) ||
    !AreSame(a->GetPoints()->GetData(), b->GetPoints()->GetData()) ||
    !AreSame(a->GetCells()->GetOffsetsArray(), b->GetCells()->GetOffsetsArray()) ||
    !AreSame(a->GetCells()->GetConnectivityArray(), b->GetCells()->GetConnectivityArray()))
  {
    return false;
  }
  for (vtkIdType i = 0; i < types->GetNumberOfTuples(); ++i)
  {
    if (isPolyhedron(types, i))
    {
      return false;
    }
  }
  return true;
}

// Copies the tuples of these ids. Arrays of damaged files can be too short; they are left out.
void CopyTuples(vtkDataSetAttributes* all, vtkDataArray* ids, vtkDataSetAttributes* to)
{
  vtkNew<vtkDataSetAttributes> from;
  from->ShallowCopy(all);
  for (int i = from->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (from->GetAbstractArray(i)->GetNumberOfTuples() <= ids->GetRange()[1])
    {
      from->RemoveArray(i);
    }
  }
  vtkNew<vtkIdList> sources;
  vtkNew<vtkIdList> targets;
  const vtkIdType number = ids->GetNumberOfTuples();
  sources->SetNumberOfIds(number);
  targets->SetNumberOfIds(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    sources->SetId(i, static_cast<vtkIdType>(ids->GetComponent(i, 0)));
    targets->SetId(i, i);
  }
  to->CopyGlobalIdsOn();
  to->CopyPedigreeIdsOn();
  to->CopyAllocate(from, number);
  to->CopyData(from, sources, targets);
}
}

//------------------------------------------------------------------------------
SurfaceExtractor::SurfaceExtractor() = default;
SurfaceExtractor::~SurfaceExtractor() = default;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SurfaceExtractor::Extract(vtkDataSet* data, ViewerMessages& messages)
{
  if (!this->Surface || !HaveSameCells(this->Last, data))
  {
    vtkNew<vtkGeometryFilter> filter;
    messages.Observe(filter, "extracting the surface");
    filter->SetInputData(data);
    filter->PassThroughCellIdsOn();
    filter->PassThroughPointIdsOn();
    filter->Update();
    this->Surface = filter->GetOutput();
  }
  this->Last = data;
  return this->CopyArrays(data);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SurfaceExtractor::CopyArrays(vtkDataSet* data) const
{
  vtkDataArray* points = this->Surface->GetPointData()->GetArray(PointIds);
  vtkDataArray* cells = this->Surface->GetCellData()->GetArray(CellIds);
  if (!points || !cells || this->Surface->GetNumberOfCells() == 0)
  {
    return this->Surface; // there are no faces
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->CopyStructure(this->Surface);
  CopyTuples(data->GetPointData(), points, surface->GetPointData());
  CopyTuples(data->GetCellData(), cells, surface->GetCellData());
  surface->GetCellData()->AddArray(cells);
  surface->GetFieldData()->ShallowCopy(data->GetFieldData());
  return surface;
}

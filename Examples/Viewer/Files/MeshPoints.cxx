// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MeshPoints.h"

#include "Text/ViewerMessages.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{
vtkIdType CountCellTypes(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes()->GetNumberOfTuples();
#else
  return grid->GetCellTypesArray()->GetNumberOfTuples();
#endif
}

using Ids = std::vector<vtkIdType>;
constexpr vtkIdType Unused = -1;

std::array<vtkCellArray*, 4> GetCells(vtkPolyData* mesh)
{
  return { { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() } };
}

// Calls f(number of corners, their point ids) for every cell.
template <typename Function>
void ForEachCell(vtkCellArray* cells, Function&& f)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    f(size, ids);
  }
}

// New ids of the used points, in the same order.
Ids NumberUsedPoints(vtkPolyData* mesh)
{
  Ids numbers(static_cast<size_t>(mesh->GetNumberOfPoints()), Unused);
  for (vtkCellArray* cells : GetCells(mesh))
  {
    ForEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          numbers[ids[i]] = 0;
        }
      });
  }
  vtkIdType next = 0;
  for (vtkIdType& number : numbers)
  {
    number = number == Unused ? Unused : next++;
  }
  return numbers;
}

void CopyPoints(vtkPolyData* from, const Ids& numbers, vtkPolyData* to)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(from->GetPoints()->GetDataType());
  vtkPointData* data = to->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(from->GetPointData(), from->GetNumberOfPoints());
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    if (numbers[i] != Unused)
    {
      points->InsertNextPoint(from->GetPoint(i));
      data->CopyData(from->GetPointData(), i, numbers[i]);
    }
  }
  data->Squeeze();
  to->SetPoints(points);
}

vtkSmartPointer<vtkCellArray> CopyCells(vtkCellArray* from, const Ids& numbers)
{
  vtkNew<vtkCellArray> to;
  Ids corners;
  ForEachCell(from,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      corners.resize(static_cast<size_t>(size));
      std::transform(ids, ids + size, corners.begin(), [&](vtkIdType id) { return numbers[id]; });
      to->InsertNextCell(size, corners.data());
    });
  return to.Get();
}
}

//------------------------------------------------------------------------------
void CheckCorners(vtkPointSet* mesh)
{
  std::vector<vtkCellArray*> groups;
  if (auto* surface = vtkPolyData::SafeDownCast(mesh))
  {
    const auto cells = GetCells(surface);
    groups.assign(cells.begin(), cells.end());
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  if (grid && grid->GetCells())
  {
    groups.push_back(grid->GetCells());
    const vtkIdType numberOfTypes = CountCellTypes(grid);
    if (numberOfTypes != grid->GetNumberOfCells())
    {
      throw ViewerError("there are " + std::to_string(numberOfTypes) + " cell types, but " +
        std::to_string(grid->GetNumberOfCells()) + " cells");
    }
  }
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  vtkIdType cell = 0;
  for (vtkCellArray* cells : groups)
  {
    ForEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          if (ids[i] < 0 || ids[i] >= numberOfPoints)
          {
            throw ViewerError("cell " + std::to_string(cell) + " refers to point " +
              std::to_string(ids[i]) + ", but there are " + std::to_string(numberOfPoints) +
              " points");
          }
        }
        ++cell;
      });
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> DropUnusedPoints(vtkPolyData* mesh)
{
  const Ids numbers = NumberUsedPoints(mesh);
  if (std::find(numbers.begin(), numbers.end(), Unused) == numbers.end())
  {
    return mesh;
  }
  vtkNew<vtkPolyData> used;
  CopyPoints(mesh, numbers, used);
  used->SetVerts(CopyCells(mesh->GetVerts(), numbers));
  used->SetLines(CopyCells(mesh->GetLines(), numbers));
  used->SetPolys(CopyCells(mesh->GetPolys(), numbers));
  used->SetStrips(CopyCells(mesh->GetStrips(), numbers));
  used->GetCellData()->ShallowCopy(mesh->GetCellData());
  used->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  return used.Get();
}

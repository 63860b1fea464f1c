// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Grids as input, and where on them picks are.
#include "vtkAdaptivePatchMapperInternals.h"

#include "Checks/ErrorCollector.h"
#include "Mesh/PatchArrays.h"
#include "Patches/NearestPatchPoint.h"
#include "vtkCellData.h"
#include "vtkCellPicker.h"
#include "vtkCommand.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{
using Locate = std::function<relevo::vec2(const relevo::PatchArrays&)>;

// The grid's cell of a triangle, and the coordinates that `locate` finds on its patch.
vtkIdType FindCell(vtkPolyData* mesh, vtkIdType triangle, double pcoords[3], const Locate& locate)
{
  relevo::PatchArrays patches;
  std::string error;
  const vtkIdType first = mesh ? mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() : 0;
  vtkIdTypeArray* cells = mesh
    ? vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetArray("vtkOriginalCellIds"))
    : nullptr;
  if (!cells || triangle < first || triangle >= cells->GetNumberOfTuples() ||
    triangle >= mesh->GetNumberOfCells() || !patches.Take(mesh, error))
  {
    return -1;
  }
  const relevo::vec2 uv = locate(patches);
  pcoords[0] = uv.x;
  pcoords[1] = uv.y;
  pcoords[2] = 0.0;
  return cells->GetValue(triangle);
}
}

int vtkAdaptivePatchMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  const int valid = this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return valid;
}

void vtkAdaptivePatchMapper::SetInputData(vtkUnstructuredGrid* grid)
{
  this->SetInputDataInternal(0, grid);
}

void vtkAdaptivePatchMapper::SetInputData(vtkPolyData* patches)
{
  this->SetInputDataInternal(0, patches);
}

vtkDataObject* vtkAdaptivePatchMapper::ConvertInput(vtkDataObject* input)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!grid)
  {
    return this->Superclass::ConvertInput(input);
  }
  vtkInternals& data = *this->Patches;
  relevo::Dependencies dependencies;
  dependencies.AddObject(grid);
  if (data.GridDependencies.Update(dependencies))
  {
    std::string errors;
    const unsigned long observer =
      data.Filter->AddObserver(vtkCommand::ErrorEvent, relevo::NewErrorCollector(errors));
    data.Filter->SetInputDataObject(grid);
    data.Filter->Update();
    data.Filter->RemoveObserver(observer);
    if (!errors.empty())
    {
      vtkErrorMacro("Not all of the grid can be drawn: " << errors);
    }
  }
  return data.Filter->GetOutput();
}

vtkIdType vtkAdaptivePatchMapper::GetPickedCell(vtkCellPicker* picker, double pcoords[3])
{
  if (!picker || picker->GetMapper() != this)
  {
    return -1;
  }
  const vtkIdType triangle = picker->GetCellId();
  const double* weights = picker->GetPCoords();
  return FindCell(vtkPolyData::SafeDownCast(picker->GetDataSet()), triangle, pcoords,
    [triangle, weights](const relevo::PatchArrays& patches)
    {
      const relevo::vec2 corner = patches.GetCoordinates(triangle, 0);
      const relevo::vec2 r = patches.GetCoordinates(triangle, 1) - corner;
      const relevo::vec2 s = patches.GetCoordinates(triangle, 2) - corner;
      return corner + r * static_cast<float>(weights[0]) + s * static_cast<float>(weights[1]);
    });
}

vtkIdType vtkAdaptivePatchMapper::GetPickedCell(
  vtkIdType cellId, const double position[3], double pcoords[3], vtkPolyData* patches)
{
  const relevo::dvec3 place(position[0], position[1], position[2]);
  return FindCell(patches ? patches : this->GetInput(), cellId, pcoords,
    [cellId, &place](const relevo::PatchArrays& arrays)
    { return relevo::FindNearestPatchPoint(arrays, arrays.GetPatchId(cellId), place); });
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSubset.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace relevo
{
vtkSmartPointer<vtkPolyData> ExtractCells(vtkPolyData* mesh, const std::vector<bool>& kept)
{
  auto cells = vtkSmartPointer<vtkPolyData>::New();
  cells->ShallowCopy(mesh);
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  const char* held = "relevo::GhostType"; // vtkGhostType marks the cells to remove meanwhile
  const auto rename = [&cells](const char* from, const char* to)
  {
    vtkCellData* data = cells->GetCellData();
    if (vtkAbstractArray* types = data->GetAbstractArray(from))
    {
      auto copy = vtk::TakeSmartPointer(types->NewInstance());
      copy->DeepCopy(types);
      copy->SetName(to);
      data->RemoveArray(from);
      data->AddArray(copy);
    }
  };
  rename(ghosts, held);
  std::vector<unsigned char> types(kept.size());
  std::transform(kept.begin(), kept.end(), types.begin(),
    [](bool isKept) { return isKept ? 0 : vtkDataSetAttributes::DUPLICATECELL; });
  SetGhostTypes(cells, types);
  cells->RemoveGhostCells();
  cells->GetCellData()->RemoveArray(ghosts);
  rename(held, ghosts);
  return cells;
}

vtkSmartPointer<vtkPolyData> AppendMeshes(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  if (meshes.empty())
  {
    return nullptr;
  }
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* mesh : meshes)
  {
    append->AddInputData(mesh);
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> all = append->GetOutput();
  all->GetFieldData()->ShallowCopy(meshes.front()->GetFieldData()); // colours of blocks
  return all;
}

void SetGhostTypes(vtkPolyData* mesh, const std::vector<unsigned char>& types)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  array->SetNumberOfValues(static_cast<vtkIdType>(types.size()));
  std::copy(types.begin(), types.end(), array->GetPointer(0));
  mesh->GetCellData()->AddArray(array);
}
}

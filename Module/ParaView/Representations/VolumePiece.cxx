// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePiece.h"

#include "Parallel/ProcessReduction.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtractBlockUsingDataAssembly.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkPartitionedDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace relevo
{
namespace
{
const char* const UnitDistanceName = "RelevoUnitDistance";

// Copies data sets, so that filters which change their output in place do not change the piece.
vtkSmartPointer<vtkDataObject> Copy(vtkDataObject* data)
{
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  auto* blocks = vtkCompositeDataSet::SafeDownCast(copy);
  if (blocks)
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(blocks->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      vtkDataObject* block = leaf->GetCurrentDataObject();
      const auto own = vtkSmartPointer<vtkDataObject>::Take(block->NewInstance());
      own->ShallowCopy(block);
      blocks->SetDataSet(leaf, own);
    }
  }
  return copy;
}

// Return the number of cells that no other process has.
vtkIdType CountCells(vtkDataSet* set)
{
  vtkIdType count = set->GetNumberOfCells();
  vtkUnsignedCharArray* ghosts = set->GetCellGhostArray();
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfValues(); ++i)
  {
    count -= (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL) != 0 ? 1 : 0;
  }
  return count;
}

double ComputeUnitDistance(vtkDataObject* input, const PieceReduction& processes)
{
  const vtkBoundingBox box = VolumePiece::GetBox(input);
  std::vector<double> sides(6, -VTK_DOUBLE_MAX); // -xmin, xmax, ...
  for (int side = 0; side < 6 && box.IsValid(); ++side)
  {
    sides[static_cast<std::size_t>(side)] = (side % 2 == 0 ? -1.0 : 1.0) * box.GetBound(side);
  }
  processes.TakeLargest(sides);
  std::vector<double> cells = { 0.0 };
  for (vtkDataSet* set : VolumePiece::GetDataSets(input))
  {
    cells[0] += static_cast<double>(CountCells(set));
  }
  processes.Add(cells);
  const double diagonal = std::hypot(sides[0] + sides[1], sides[2] + sides[3], sides[4] + sides[5]);
  const double distance = diagonal / std::cbrt(cells[0]);
  return distance > 0.0 && std::isfinite(distance) ? distance : 1.0;
}
}

VolumePiece::VolumePiece()
{
  this->Blocks->SetSelector("/");
}

vtkSmartPointer<vtkDataObject> VolumePiece::Make(vtkDataObject* input)
{
  if (!input)
  {
    return vtkSmartPointer<vtkPartitionedDataSet>::New();
  }
  if (!vtkCompositeDataSet::SafeDownCast(input))
  {
    return Copy(input);
  }
  this->Blocks->SetInputDataObject(input);
  this->Blocks->Update();
  const auto piece = Copy(this->Blocks->GetOutputDataObject(0));
  this->Blocks->SetInputDataObject(nullptr);
  return piece;
}

void VolumePiece::StoreUnitDistance(
  vtkDataObject* piece, vtkDataObject* input, vtkMultiProcessController* controller)
{
  const double distance = controller && controller->GetNumberOfProcesses() > 1
    ? ComputeUnitDistance(input, ProcessReduction(controller))
    : ComputeUnitDistance(input, PieceReduction());
  if (!piece || piece->GetFieldData()->HasArray(UnitDistanceName))
  {
    return; // a change would make the mapper rebuild the mesh
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(UnitDistanceName);
  array->InsertNextValue(distance);
  piece->GetFieldData()->AddArray(array);
}

double VolumePiece::GetUnitDistance(vtkDataObject* piece)
{
  vtkDataArray* distance = piece ? piece->GetFieldData()->GetArray(UnitDistanceName) : nullptr;
  return distance ? distance->GetComponent(0, 0) : 1.0;
}

std::vector<vtkDataSet*> VolumePiece::GetDataSets(vtkDataObject* piece)
{
  std::vector<vtkDataSet*> sets;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(piece))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(blocks->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (auto* set = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
      {
        sets.push_back(set);
      }
    }
  }
  else if (auto* set = vtkDataSet::SafeDownCast(piece))
  {
    sets.push_back(set);
  }
  return sets;
}

vtkBoundingBox VolumePiece::GetBox(vtkDataObject* piece)
{
  vtkBoundingBox box;
  for (vtkDataSet* set : GetDataSets(piece))
  {
    double bounds[6];
    set->GetBounds(bounds);
    if (vtkBoundingBox::IsValid(bounds))
    {
      box.AddBounds(bounds);
    }
  }
  return box;
}

int VolumePiece::GetNumberOfComponents(
  vtkDataObject* piece, int association, const std::string& name)
{
  for (vtkDataSet* set : GetDataSets(piece))
  {
    vtkDataSetAttributes* arrays = set->GetAttributes(association);
    vtkDataArray* array = arrays ? arrays->GetArray(name.c_str()) : nullptr;
    if (array)
    {
      return array->GetNumberOfComponents();
    }
  }
  return 0;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchTree.h"

#include "Composite/DataLeaves.h"
#include "FaceOrder.h"
#include "FacePolygons.h"
#include "MapperMessage.h"
#include "Mesh/PatchArrays.h"
#include "SharedFaces.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <utility>

namespace relevo
{
namespace
{
// Return the faces that a view has delivered, without the repeated ghosts of merged pieces, in an
// order that does not depend on the number of processes.
vtkSmartPointer<vtkPolyData> FindFaces(vtkPolyData* delivered)
{
  vtkSmartPointer<vtkPolyData> faces = RemoveRepeatedGhosts(delivered);
  if (faces != delivered)
  {
    SortByPosition(faces);
  }
  return faces;
}

// Return the patches of faces. Their original cells are the faces.
vtkSmartPointer<vtkPolyData> RunFilter(vtkPolyData* faces, std::string& warnings)
{
  vtkNew<vtkCallbackCommand> collector;
  collector->SetClientData(&warnings);
  collector->SetCallback(
    [](vtkObject*, unsigned long, void* text, void* message)
    {
      auto& all = *static_cast<std::string*>(text);
      all += (all.empty() ? "" : " ") + ReadMapperMessage(message);
    });
  vtkNew<vtkPatchSurfaceFilter> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, collector);
  filter->AddObserver(vtkCommand::WarningEvent, collector);
  filter->SetInputData(MakeFaceGrid(faces));
  filter->Update();
  return filter->GetOutput();
}

// Ids need no coefficients.
void RemoveNodesOfIds(vtkPolyData* patches)
{
  const std::string prefix = std::string(PatchNodesPrefix) + "vtk";
  vtkFieldData* data = patches->GetFieldData();
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const char* name = data->GetAbstractArray(i)->GetName();
    if (name && std::string(name).compare(0, prefix.size(), prefix) == 0)
    {
      data->RemoveArray(i);
    }
  }
}
}

vtkSmartPointer<vtkPolyData> MakePatches(vtkPolyData* faces, std::vector<vtkIdType>& cells)
{
  std::string warnings; // reported when the patches are drawn
  vtkSmartPointer<vtkPolyData> patches = RunFilter(faces, warnings);
  const vtkIdType first = faces->GetNumberOfVerts() + faces->GetNumberOfLines();
  auto ids =
    vtkIdTypeArray::SafeDownCast(patches->GetCellData()->GetAbstractArray(OriginalCellIdsName));
  cells.resize(static_cast<std::size_t>(patches->GetNumberOfCells()));
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = first + ids->GetValue(static_cast<vtkIdType>(i));
  }
  return patches;
}

const PatchTree::Leaf& PatchTree::MakeLeaf(vtkPolyData* faces, std::vector<Leaf>& previous)
{
  const auto found = std::find_if(previous.begin(), previous.end(),
    [faces](const Leaf& leaf) { return leaf.Faces == faces && leaf.Time == faces->GetMTime(); });
  if (found != previous.end())
  {
    this->Leaves.push_back(*found);
    return this->Leaves.back();
  }
  Leaf leaf{ faces, faces->GetMTime(), nullptr, "" };
  leaf.Patches = RunFilter(FindFaces(faces), leaf.Warning);
  RestoreOriginalIds(leaf.Patches);
  RemoveNodesOfIds(leaf.Patches);
  this->Leaves.push_back(leaf);
  return this->Leaves.back();
}

vtkDataObject* PatchTree::Make(vtkDataObject* faces)
{
  auto tree = vtkCompositeDataSet::SafeDownCast(faces);
  if (this->Faces == faces && this->Time == (faces ? faces->GetMTime() : 0))
  {
    return this->Patches;
  }
  this->Faces = faces;
  this->Time = faces ? faces->GetMTime() : 0;
  std::vector<Leaf> previous;
  previous.swap(this->Leaves);
  this->Warnings.clear();
  std::map<unsigned int, vtkSmartPointer<vtkPolyData>> patches;
  for (const DataLeaf& input : FindDataLeaves(tree))
  {
    auto mesh = vtkPolyData::SafeDownCast(input.Data);
    if (!mesh)
    {
      continue;
    }
    const Leaf& leaf = this->MakeLeaf(mesh, previous);
    patches[input.FlatIndex] = leaf.Patches;
    if (!leaf.Warning.empty())
    {
      this->Warnings += (this->Warnings.empty() ? "" : " ") + leaf.Warning;
    }
  }
  this->Patches = nullptr;
  if (tree)
  {
    this->Patches = ReplaceLeaves(tree,
      [&patches](unsigned int index)
      { return patches.count(index) ? patches[index].Get() : nullptr; });
    this->Patches->GetFieldData()->ShallowCopy(tree->GetFieldData()); // read by the base class
  }
  return this->Patches;
}
}

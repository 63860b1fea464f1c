// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MergedBlocks.h"

#include "Text/ViewerMessages.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <string>
#include <vector>

namespace
{
using Blocks = std::vector<vtkSmartPointer<vtkDataSet>>;

// The components of an array, and the number of blocks that have it.
struct Presence
{
  int Components = 0;
  std::size_t Blocks = 0;
};

vtkSmartPointer<vtkDoubleArray> MakeFilled(
  vtkDataArray* values, const std::string& name, int components, vtkIdType tuples)
{
  auto filled = vtkSmartPointer<vtkDoubleArray>::New();
  if (values)
  {
    filled->DeepCopy(values);
  }
  else
  {
    filled->SetNumberOfComponents(components);
    filled->SetNumberOfTuples(tuples);
    filled->Fill(vtkMath::Nan());
  }
  filled->SetName(name.c_str());
  return filled;
}

// vtkAppendFilter drops arrays that some blocks lack.
void FillArrays(const Blocks& blocks, int association)
{
  std::map<std::string, Presence> arrays;
  for (vtkDataSet* block : blocks)
  {
    vtkDataSetAttributes* attributes = block->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName())
      {
        Presence& presence = arrays[array->GetName()];
        presence.Components = array->GetNumberOfComponents();
        ++presence.Blocks;
      }
    }
  }
  arrays.erase(vtkDataSetAttributes::GhostArrayName());
  for (const auto& array : arrays)
  {
    if (array.second.Blocks == blocks.size())
    {
      continue;
    }
    for (vtkDataSet* block : blocks)
    {
      vtkDataSetAttributes* attributes = block->GetAttributes(association);
      attributes->AddArray(MakeFilled(attributes->GetArray(array.first.c_str()), array.first,
        array.second.Components, block->GetNumberOfElements(association)));
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> MergeBlocks(vtkDataObject* data, ViewerMessages& messages)
{
  Blocks blocks;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    if (block->GetNumberOfPoints() > 0)
    {
      blocks.emplace_back();
      blocks.back().TakeReference(block->NewInstance());
      blocks.back()->ShallowCopy(block);
    }
  }
  if (blocks.size() < 2)
  {
    return blocks.empty() ? nullptr : blocks.front();
  }
  vtkNew<vtkAppendFilter> append;
  messages.Observe(append, "appending blocks");
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    FillArrays(blocks, association);
  }
  for (vtkDataSet* block : blocks)
  {
    append->AddInputData(block);
  }
  append->Update();
  messages.Check();
  return append->GetOutput();
}

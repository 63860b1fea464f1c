// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MergedBlocks.h"

#include "Files/ResultBlocks.h"
#include "Text/ViewerMessages.h"

#include "vtkAppendFilter.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <set>
#include <string>
#include <vector>

namespace
{
using Blocks = std::vector<ResultBlock>;

std::string CountComponents(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  return std::to_string(components) + (components == 1 ? " component" : " components");
}

// An array of all blocks. vtkAppendFilter drops arrays that some blocks lack, or whose types or
// numbers of components differ.
class SharedArray
{
public:
  SharedArray(const Blocks& blocks, int association, const std::string& name)
    : All(blocks)
    , Association(association)
    , Name(name)
  {
    for (this->First = 0; !this->Find(this->First); ++this->First)
    {
    }
  }

  bool IsDropped() const
  {
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      vtkDataArray* array = this->Find(i);
      if (!array || !this->Fits(array) ||
        array->GetDataType() != this->Find(this->First)->GetDataType())
      {
        return true;
      }
    }
    return false;
  }

  // Makes arrays of doubles that are NaN in the blocks whose array does not fit.
  void Fill() const
  {
    const int components = this->Find(this->First)->GetNumberOfComponents();
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      vtkDataArray* array = this->Find(i);
      vtkNew<vtkDoubleArray> filled;
      if (array && this->Fits(array))
      {
        filled->DeepCopy(array);
      }
      else
      {
        filled->SetNumberOfComponents(components);
        filled->SetNumberOfTuples(this->All[i].Data->GetNumberOfElements(this->Association));
        filled->Fill(vtkMath::Nan());
      }
      filled->SetName(this->Name.c_str());
      this->GetAttributes(i)->AddArray(filled);
    }
  }

  // Returns a warning about blocks whose array does not fit, or "". Blocks without it are normal.
  std::string DescribeMisfits() const
  {
    std::string text;
    int others = 0;
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      vtkDataArray* array = this->Find(i);
      if (array ? this->Fits(array) : !this->GetAttributes(i)->HasArray(this->Name.c_str()))
      {
        continue;
      }
      others += text.empty() ? 0 : 1;
      text = text.empty() ? this->DescribeMisfit(i) : text;
    }
    return others == 0 ? text
                       : text + ", and " + std::to_string(others) + " more " +
        (others == 1 ? "block differs" : "blocks differ");
  }

private:
  // Returns the array, or nullptr if the block has none of numbers.
  vtkDataArray* Find(std::size_t block) const
  {
    return this->GetAttributes(block)->GetArray(this->Name.c_str());
  }
  vtkDataSetAttributes* GetAttributes(std::size_t block) const
  {
    return this->All[block].Data->GetAttributes(this->Association);
  }
  bool Fits(vtkDataArray* array) const
  {
    return array->GetNumberOfComponents() == this->Find(this->First)->GetNumberOfComponents();
  }
  std::string DescribeMisfit(std::size_t block) const
  {
    vtkDataArray* array = this->Find(block);
    const bool isOfPoints = this->Association == vtkDataObject::POINT;
    return std::string("the array of ") + (isOfPoints ? "points" : "cells") + " '" + this->Name +
      "' has no values in " + this->All[block].Describe(block + 1) + ": " +
      (array ? "it has " + CountComponents(array) + " there, but " : "it is text there, but has ") +
      CountComponents(this->Find(this->First)) + " in " +
      this->All[this->First].Describe(this->First + 1);
  }

  const Blocks& All;
  int Association;
  std::string Name;
  std::size_t First; // the block that determines the number of components
};

std::set<std::string> FindNames(const Blocks& blocks, int association)
{
  std::set<std::string> names;
  for (const ResultBlock& block : blocks)
  {
    vtkDataSetAttributes* attributes = block.Data->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName())
      {
        names.insert(array->GetName());
      }
    }
  }
  names.erase(vtkDataSetAttributes::GhostArrayName());
  return names;
}

void FillArrays(const Blocks& blocks, int association, ViewerMessages& messages)
{
  for (const std::string& name : FindNames(blocks, association))
  {
    const SharedArray array(blocks, association, name);
    const std::string warning = array.DescribeMisfits();
    if (!warning.empty())
    {
      messages.Warn(warning);
    }
    if (array.IsDropped())
    {
      array.Fill();
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> MergeBlocks(vtkDataObject* data, ViewerMessages& messages)
{
  Blocks blocks;
  for (const ResultBlock& block : GetBlocks(data))
  {
    if (block.Data->GetNumberOfPoints() > 0)
    {
      const auto copy = vtkSmartPointer<vtkDataSet>::Take(block.Data->NewInstance());
      copy->ShallowCopy(block.Data);
      blocks.push_back({ copy, block.Name });
    }
  }
  if (blocks.size() < 2)
  {
    return blocks.empty() ? nullptr : blocks.front().Data;
  }
  vtkNew<vtkAppendFilter> append;
  messages.Observe(append, "appending blocks");
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    FillArrays(blocks, association, messages);
  }
  for (const ResultBlock& block : blocks)
  {
    append->AddInputData(block.Data);
  }
  append->Update();
  messages.Check();
  return append->GetOutput();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ResultBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

//------------------------------------------------------------------------------
std::string ResultBlock::Describe(std::size_t number) const
{
  const std::string block = "block " + std::to_string(number);
  return this->Name.empty() ? block : block + " '" + this->Name + "'";
}

//------------------------------------------------------------------------------
std::vector<ResultBlock> GetBlocks(vtkDataObject* data)
{
  std::vector<ResultBlock> blocks;
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    blocks.push_back({ set, "" });
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      auto* block = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
      const char* name = leaf->HasCurrentMetaData()
        ? leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
        : nullptr;
      if (block)
      {
        blocks.push_back({ block, name ? name : "" });
      }
    }
  }
  return blocks;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Reliefs.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"

namespace relevo
{
namespace
{
std::string FindError(vtkDataObject* object, Relief& relief)
{
  vtkImageData* image = vtkImageData::SafeDownCast(object);
  return object && !image
    ? std::string("A relief must be a vtkImageData, not a ") + object->GetClassName() + "."
    : relief.Read(image);
}

std::string GetName(vtkCompositeDataIterator* leaf)
{
  vtkInformation* information = leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData() : nullptr;
  const char* name = information ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}
}

std::string ReliefBlock::Describe(const std::string& sentence) const
{
  return this->FlatIndex == 0 ? sentence
                              : "Block " + std::to_string(this->FlatIndex) +
      (this->Name.empty() ? "" : " (" + this->Name + ")") + ": " + sentence;
}

std::vector<ReliefBlock> ReadReliefs(vtkDataObject* input)
{
  std::vector<ReliefBlock> blocks;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    blocks.emplace_back();
    blocks.back().Error = FindError(input, blocks.back().Data);
    return blocks;
  }
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    blocks.emplace_back();
    ReliefBlock& block = blocks.back();
    block.FlatIndex = leaf->GetCurrentFlatIndex();
    block.Name = GetName(leaf);
    block.Error = FindError(leaf->GetCurrentDataObject(), block.Data);
    if (!block.Error.empty())
    {
      block.Error = block.Describe(block.Error);
    }
  }
  return blocks;
}
}

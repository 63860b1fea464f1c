// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks/LeftOutBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <algorithm>

namespace relevo
{
std::string GetBlockName(vtkCompositeDataIterator* leaf)
{
  const std::string block = "Block " + std::to_string(leaf->GetCurrentFlatIndex());
  const char* name = leaf->HasCurrentMetaData()
    ? leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? block + " (\"" + name + "\")" : block;
}

void LeftOutBlocks::Add(const std::string& name, const std::string& lack)
{
  constexpr int maximumNamed = 5;
  if (++this->Count <= maximumNamed)
  {
    this->Sentences += (this->Count > 1 ? " " : "") + name + " " + lack + "; it is left out.";
  }
  this->NumberOfMore = this->Count - std::min(this->Count, maximumNamed);
}

std::string LeftOutBlocks::GetText() const
{
  return this->NumberOfMore == 0
    ? this->Sentences
    : this->Sentences + " " + std::to_string(this->NumberOfMore) + " more blocks are left out.";
}
}

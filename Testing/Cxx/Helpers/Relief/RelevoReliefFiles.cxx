// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoReliefFiles.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"

vtkImageData* RelevoGetImage(vtkDataObject* blocks, unsigned int block)
{
  auto* set = vtkMultiBlockDataSet::SafeDownCast(blocks);
  return set ? vtkImageData::SafeDownCast(set->GetBlock(block)) : nullptr;
}

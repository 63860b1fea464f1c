// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoBlocks.h"

#include "RelevoCheck.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkMultiBlockDataSet.h"

bool RelevoRefusesBlock(
  vtkAlgorithm* algorithm, int port, vtkDataObject* block, const std::string& words)
{
  RelevoErrors errors(algorithm);
  RelevoErrors executive(algorithm->GetExecutive());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, block);
  algorithm->SetInputDataObject(port, blocks);
  algorithm->Update();
  return errors.Said(words) &&
    algorithm->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) == 0;
}

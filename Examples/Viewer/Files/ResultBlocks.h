// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the data sets of a file, with their names
 */
#ifndef ResultBlocks_h
#define ResultBlocks_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

struct ResultBlock
{
  vtkSmartPointer<vtkDataSet> Data;
  std::string Name; // empty if it has none

  /// Returns "block NUMBER", with its name if it has one. The first block has the number 1.
  std::string Describe(std::size_t number) const;
};

/// Returns the data set, or those of a composite data set in their order.
std::vector<ResultBlock> GetBlocks(vtkDataObject* data);

#endif

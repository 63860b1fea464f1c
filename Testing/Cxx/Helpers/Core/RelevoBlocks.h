// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of composite inputs, whose types VTK does not check.
#ifndef RelevoBlocks_h
#define RelevoBlocks_h

#include <string>

class vtkAlgorithm;
class vtkDataObject;

// Whether an algorithm whose input of this port is a composite data set with one block says
// `words`, and has no points as output.
bool RelevoRefusesBlock(
  vtkAlgorithm* algorithm, int port, vtkDataObject* block, const std::string& words);

#endif

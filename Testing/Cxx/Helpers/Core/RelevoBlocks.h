// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks inputs whose blocks have a type that VTK does not check.
#ifndef RelevoBlocks_h
#define RelevoBlocks_h

#include <string>

class vtkAlgorithm;
class vtkDataObject;

// Whether an algorithm reports `words` and has an output without points if the input of this port
// is a composite data set with one block.
bool RelevoRefusesBlock(
  vtkAlgorithm* algorithm, int port, vtkDataObject* block, const std::string& words);

#endif

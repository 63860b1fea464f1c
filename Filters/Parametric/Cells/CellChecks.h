// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which cells of a grid can be made patches, and what is wrong with the others
 *
 * Private to the module's own sources.
 */
#ifndef CellChecks_h
#define CellChecks_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace relevo
{
enum class CellUse : unsigned char
{
  None, // points, lines, and cells with faults
  Surface,
  Solid
};

struct CellChecks
{
  std::vector<CellUse> Uses; // for each cell
  std::vector<std::string> Faults;
};

/// One text for each kind of fault, with its first cell and how many others there are.
CellChecks CheckCells(vtkUnstructuredGrid* grid);
}

#endif

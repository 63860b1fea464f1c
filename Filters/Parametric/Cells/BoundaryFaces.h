// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the faces of cells that no other cell has
 *
 * Private to the module's own sources.
 */
#ifndef BoundaryFaces_h
#define BoundaryFaces_h

#include "Cells/CellChecks.h"
#include "vtkType.h"

#include <vector>

class vtkUnstructuredGrid;

namespace relevo
{
struct CellFace
{
  vtkIdType Cell;
  int Face;
};

/// All faces of surface cells, and those of solid cells whose corners are those of no other solid
/// cell's; in the order of the cells.
std::vector<CellFace> FindBoundaryFaces(
  vtkUnstructuredGrid* grid, const std::vector<CellUse>& uses);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   extraction of faces that belong to only one cell
 *
 * Private to the module.
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

/// Returns all faces of 2D cells, and the faces of 3D cells that no other 3D cell shares, in the
/// order of the cells. Faces are compared by their corners.
std::vector<CellFace> FindBoundaryFaces(
  vtkUnstructuredGrid* grid, const std::vector<CellUse>& uses);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   faces of cells as 2D cells
 *
 * Private to the module.
 */
#ifndef FaceCells_h
#define FaceCells_h

#include "Cells/BoundaryFaces.h"
#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
struct FaceCell
{
  vtkIdType Cell; // whose face this is
  int Type;
  ivec2 Degrees;
  std::vector<vtkIdType> Points; // of the grid, in VTK's order
};

/// Return a cell for each face, or for each triangle of a strip, from which CollectNodes() collects
/// the same nodes.
std::vector<FaceCell> MakeFaceCells(vtkUnstructuredGrid* grid, const std::vector<CellFace>& faces);
}

#endif

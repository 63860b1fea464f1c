// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  CoarseCell
 * @brief   the input's cell that contains a point of the refined surface
 */
#ifndef CoarseCell_h
#define CoarseCell_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

class vtkGenericCell;
class vtkIdList;
class vtkPolyData;

namespace relevo
{
class RefinementMesh;
struct SurfaceHit;

/**
 * Get the type of a cell (VTK_EMPTY_CELL if it has too few points), its points, or the cell. Unlike
 * the methods of vtkPolyData, these functions accept cells of any type and are thread-safe.
 */
//@{
RELEVOFILTERSREFINEMENT_EXPORT int GetCellType(vtkPolyData* input, vtkIdType cellId);
RELEVOFILTERSREFINEMENT_EXPORT void GetCellPoints(
  vtkPolyData* input, vtkIdType cellId, vtkIdList* points);
RELEVOFILTERSREFINEMENT_EXPORT void GetCell(
  vtkPolyData* input, vtkIdType cellId, vtkGenericCell* cell);
//@}

struct RELEVOFILTERSREFINEMENT_EXPORT CoarseCell
{
  vtkIdType CellId = -1;
  /// The triangle of a strip, in VTK's numbering. Otherwise, the sub-id of the cell.
  int SubId = 0;
  /// In the cell, or in the triangle of the strip, at the point before displacement.
  double PCoords[3] = { 0.0, 0.0, 0.0 };

  /**
   * Find the cell of a hit and copy it, or the triangle of the strip, to `cell`.
   */
  CoarseCell(
    vtkPolyData* input, const RefinementMesh& mesh, const SurfaceHit& hit, vtkGenericCell* cell);
};

/**
 * Reverse a flat cell, without changing its shape, so that it faces along a unit normal. Pickers
 * that compute normals from a cell's points then find this normal.
 */
RELEVOFILTERSREFINEMENT_EXPORT void TurnCell(vtkGenericCell* cell, const double normal[3]);
}

#endif

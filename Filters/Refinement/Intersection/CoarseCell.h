// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  CoarseCell
 * @brief   the input's cell that a point of the refined surface was made of
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
 * The type of a cell, VTK_EMPTY_CELL where it has too few points for its kind; its points; and the
 * cell. As vtkPolyData has them, but for any cells, of which it takes only some, and from any
 * thread.
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
  /// The triangle of a strip, as VTK counts them; else the cell's own.
  int SubId = 0;
  /// In the cell, or in the strip's triangle, where the point was before it was moved.
  double PCoords[3] = { 0.0, 0.0, 0.0 };

  /**
   * Find the cell of a hit, and put it, or the strip's triangle, into `cell`.
   */
  CoarseCell(
    vtkPolyData* input, const RefinementMesh& mesh, const SurfaceHit& hit, vtkGenericCell* cell);
};

/**
 * Turn a flat cell, without changing its shape, so that it faces along a unit normal: pickers that
 * compute normals from a cell's points find this one.
 */
RELEVOFILTERSREFINEMENT_EXPORT void TurnCell(vtkGenericCell* cell, const double normal[3]);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GhostCells
 * @brief   cells that another piece of the data set draws
 *
 * Their vtkGhostType has vtkDataSetAttributes::DUPLICATECELL. They count as neighbours, but nothing
 * is drawn or made of them. Not wrapped: for the modules' own sources.
 */
#ifndef GhostCells_h
#define GhostCells_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"

class vtkPolyData;
class vtkUnsignedCharArray;

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT GhostCells
{
public:
  explicit GhostCells(vtkPolyData* mesh);

  /// Whether there are any, among cells [first, end).
  bool AreAmong(vtkIdType first, vtkIdType end) const;

  bool Has(vtkIdType cell) const;

private:
  vtkUnsignedCharArray* Types;
};

/**
 * Give `output`, a shallow copy of `input`, vertices and lines of its own where some are ghosts:
 * these become cells without points, so that all cells keep their ids.
 */
RELEVOFILTERSCORE_EXPORT void EmptyGhosts(vtkPolyData* input, vtkPolyData* output);

/// The same of polygons and strips, for what has no use for neighbours.
RELEVOFILTERSCORE_EXPORT void EmptyGhostFaces(vtkPolyData* input, vtkPolyData* output);
}

#endif

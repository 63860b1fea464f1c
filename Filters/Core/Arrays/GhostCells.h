// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GhostCells
 * @brief   ghost cells that another piece of the data set draws
 *
 * These cells have vtkDataSetAttributes::DUPLICATECELL in vtkGhostType. They are used as neighbours
 * but are neither drawn nor part of outputs.
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

  /// Whether there are any among the cells [first, end).
  bool AreAmong(vtkIdType first, vtkIdType end) const;

  bool Has(vtkIdType cell) const;

private:
  vtkUnsignedCharArray* Types;
};

/**
 * Replace the vertices and lines of `output`, a shallow copy of `input`, if some are ghost cells.
 * Ghost cells become cells without points, so that all cells keep their ids.
 */
RELEVOFILTERSCORE_EXPORT void EmptyGhosts(vtkPolyData* input, vtkPolyData* output);

/// Does the same for polygons and strips, for algorithms that do not use neighbours.
RELEVOFILTERSCORE_EXPORT void EmptyGhostFaces(vtkPolyData* input, vtkPolyData* output);
}

#endif

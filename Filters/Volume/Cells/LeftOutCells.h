// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LeftOutCells
 * @brief   the cells of a data set that are hidden or belong to another piece
 *
 * Private to the module.
 */
#ifndef LeftOutCells_h
#define LeftOutCells_h

#include "vtkType.h"

class vtkDataSet;
class vtkIdList;
class vtkUnsignedCharArray;

namespace relevo
{
class LeftOutCells
{
public:
  /// The data set must outlive this object.
  explicit LeftOutCells(vtkDataSet* mesh);

  bool IsGhost(vtkIdType cell) const;
  /// Returns whether the cell with these points is blanked.
  bool IsHidden(vtkIdType cell, vtkIdList* points) const;

private:
  bool HasFlag(vtkIdType cell, int flags) const;

  vtkUnsignedCharArray* Cells;
  vtkUnsignedCharArray* Points;
};
}

#endif

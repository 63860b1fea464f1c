// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/LeftOutCells.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkUnsignedCharArray.h"

namespace relevo
{
LeftOutCells::LeftOutCells(vtkDataSet* mesh)
  : Cells(mesh->GetCellGhostArray())
  , Points(mesh->GetPointGhostArray())
{
}

bool LeftOutCells::IsGhost(vtkIdType cell) const
{
  return this->HasFlag(cell, vtkDataSetAttributes::DUPLICATECELL);
}

bool LeftOutCells::IsHidden(vtkIdType cell, vtkIdList* points) const
{
  if (this->HasFlag(cell, vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL))
  {
    return true;
  }
  for (vtkIdType i = 0; this->Points && i < points->GetNumberOfIds(); ++i)
  {
    const vtkIdType point = points->GetId(i);
    if (point < this->Points->GetNumberOfTuples() &&
      (this->Points->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT))
    {
      return true;
    }
  }
  return false;
}

bool LeftOutCells::HasFlag(vtkIdType cell, int flags) const
{
  return this->Cells && cell < this->Cells->GetNumberOfTuples() &&
    (this->Cells->GetValue(cell) & flags) != 0;
}
}

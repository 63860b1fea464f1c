// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PointBlanking
 * @brief   the hidden points of a data set
 *
 * This is vtkImageData::IsPointVisible() for any data set. A ghost array with too few values, or
 * with more than one component, is ignored; VTK reads past its end.
 */
#ifndef PointBlanking_h
#define PointBlanking_h

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace relevo
{
class PointBlanking
{
public:
  explicit PointBlanking(vtkDataSet* data)
    : Ghosts(data->GetPointGhostArray())
  {
    if (this->Ghosts &&
      (this->Ghosts->GetNumberOfComponents() != 1 ||
        this->Ghosts->GetNumberOfTuples() < data->GetNumberOfPoints()))
    {
      this->Ghosts = nullptr;
    }
  }

  bool IsHidden(vtkIdType point) const
  {
    return this->Ghosts && (this->Ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
  }

  bool HidesAny() const
  {
    for (vtkIdType point = 0; this->Ghosts && point < this->Ghosts->GetNumberOfTuples(); ++point)
    {
      if (this->IsHidden(point))
      {
        return true;
      }
    }
    return false;
  }

private:
  vtkUnsignedCharArray* Ghosts;
};
}

#endif

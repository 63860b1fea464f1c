// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PointBlanking
 * @brief   which points of a data set are hidden
 *
 * As vtkImageData::IsPointVisible(), but an array of ghosts that has too few values for the points,
 * or more than one each, counts as none: VTK reads past its end. Private to the modules.
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

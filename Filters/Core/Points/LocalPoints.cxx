// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Points/LocalPoints.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
FiniteBox MeasurePoints(vtkPoints* points)
{
  FiniteBox box;
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    box.Add(point);
  }
  return box;
}

void LocalPoints::Build(vtkPoints* points, const FiniteBox* whole)
{
  this->Coordinates.clear();
  std::fill_n(this->Origin, 3, 0.0);
  if (!points)
  {
    return;
  }
  vtkDataArray* data = points->GetData();
  if (data->GetDataType() != VTK_FLOAT)
  {
    const FiniteBox box = whole ? *whole : MeasurePoints(points);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Origin[axis] = box.GetMiddle(axis);
    }
  }
  this->Coordinates.resize(3 * static_cast<size_t>(data->GetNumberOfTuples()));
  vtkSMPTools::For(0, data->GetNumberOfTuples(),
    [this, data](vtkIdType begin, vtkIdType end)
    {
      double point[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        data->GetTuple(i, point);
        for (int c = 0; c < 3; ++c)
        {
          // Adding 0 converts -0 to 0.
          this->Coordinates[3 * i + c] = static_cast<float>(point[c] - this->Origin[c]) + 0.0f;
        }
      }
    });
}
}

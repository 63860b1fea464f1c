// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LocalPoints.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// The middle of the finite coordinates; 0 without any.
double GetMiddle(vtkDataArray* points, int axis)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    const double x = points->GetComponent(i, axis);
    if (std::isfinite(x))
    {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  return low <= high ? 0.5 * low + 0.5 * high : 0.0;
}
}

namespace relevo
{
void LocalPoints::Build(vtkPoints* points)
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
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Origin[axis] = GetMiddle(data, axis);
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
          // Adding zero makes -0 a plain 0.
          this->Coordinates[3 * i + c] = static_cast<float>(point[c] - this->Origin[c]) + 0.0f;
        }
      }
    });
}
}

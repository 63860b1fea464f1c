// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/JoinedPoints.h"

#include "Cells/VolumeCells.h"
#include "Points/MergedPoints.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <numeric>

namespace relevo
{
std::vector<vtkIdType> FindJoinedPoints(const VolumeCells& cells)
{
  const std::vector<dvec3>& points = cells.GetPoints();
  const std::vector<Scalars>& scalars = cells.GetPointScalars();
  const vtkIdType count = static_cast<vtkIdType>(points.size());
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetArray(const_cast<double*>(points.empty() ? nullptr : &points[0].x), 3 * count, 1);
  vtkNew<vtkPoints> all;
  all->SetData(coordinates);
  std::vector<vtkIdType> joined = ComputePlaces(all);
  if (joined.empty())
  {
    joined.resize(points.size());
    std::iota(joined.begin(), joined.end(), 0);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    joined[i] = scalars[joined[i]] == scalars[i] ? joined[i] : i;
  }
  return joined;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/MergedCellPoints.h"

#include "Cells/VolumeCells.h"
#include "Points/MergedPoints.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <numeric>

namespace relevo
{
std::vector<vtkIdType> FindMergedPoints(const VolumeCells& cells)
{
  const std::vector<dvec3>& points = cells.GetPoints();
  const std::vector<Scalars>& scalars = cells.GetPointScalars();
  const vtkIdType count = static_cast<vtkIdType>(points.size());
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetArray(const_cast<double*>(points.empty() ? nullptr : &points[0].x), 3 * count, 1);
  vtkNew<vtkPoints> all;
  all->SetData(coordinates);
  std::vector<vtkIdType> merged = ComputeMergedPoints(all);
  if (merged.empty())
  {
    merged.resize(points.size());
    std::iota(merged.begin(), merged.end(), 0);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    merged[i] = scalars[merged[i]] == scalars[i] ? merged[i] : i;
  }
  return merged;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/MergedCellPoints.h"

#include "Cells/VolumeCells.h"
#include "Points/MergedPoints.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace relevo
{
namespace
{
std::vector<vtkIdType> MergePoints(const std::vector<dvec3>& points)
{
  const vtkIdType count = static_cast<vtkIdType>(points.size());
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetArray(const_cast<double*>(points.empty() ? nullptr : &points[0].x), 3 * count, 1);
  vtkNew<vtkPoints> all;
  all->SetData(coordinates);
  return ComputeMergedPoints(all);
}
}

std::vector<vtkIdType> FindPlaces(const std::vector<dvec3>& points)
{
  std::vector<vtkIdType> places = MergePoints(points);
  if (places.empty())
  {
    places.resize(points.size());
    std::iota(places.begin(), places.end(), 0);
  }
  return places;
}

MergedCellPoints MergeCellPoints(const VolumeCells& cells)
{
  const ScalarTable& scalars = cells.GetPointScalars();
  MergedCellPoints merged;
  merged.Places = MergePoints(cells.GetPoints());
  merged.Points = merged.Places;
  // Points whose scalars differ from those of the first point at their place. Scalars that are not
  // finite equal no others.
  std::vector<vtkIdType> others;
  for (size_t i = 0; i < merged.Places.size(); ++i)
  {
    if (!(scalars[merged.Places[i]] == scalars[i]))
    {
      merged.Points[i] = static_cast<vtkIdType>(i);
      if (IsFinite(scalars[i]))
      {
        others.push_back(static_cast<vtkIdType>(i));
      }
    }
  }
  vtkSMPTools::Sort(others.begin(), others.end(),
    [&](vtkIdType a, vtkIdType b)
    {
      return std::make_tuple(merged.Places[a], scalars[a], a) <
        std::make_tuple(merged.Places[b], scalars[b], b);
    });
  for (size_t i = 1; i < others.size(); ++i)
  {
    const vtkIdType before = others[i - 1];
    const vtkIdType point = others[i];
    if (merged.Places[before] == merged.Places[point] && scalars[before] == scalars[point])
    {
      merged.Points[point] = merged.Points[before];
    }
  }
  return merged;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   merging of coincident points of several data sets
 *
 * Private to the modules.
 */
#ifndef MergedCellPoints_h
#define MergedCellPoints_h

#include "Integral/Ray.h"              // for vectors
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace relevo
{
class VolumeCells;

/// The lists are empty if no points coincide.
struct MergedCellPoints
{
  /// Returns the first point that coincides with a point.
  vtkIdType GetPlace(vtkIdType point) const { return Get(this->Places, point); }
  /// Returns the first point that coincides with a point and has the same scalars.
  vtkIdType GetPoint(vtkIdType point) const { return Get(this->Points, point); }

  std::vector<vtkIdType> Places;
  std::vector<vtkIdType> Points;

private:
  static vtkIdType Get(const std::vector<vtkIdType>& all, vtkIdType point)
  {
    return all.empty() ? point : all[static_cast<size_t>(point)];
  }
};

/// Returns for each point the first coincident point.
std::vector<vtkIdType> FindPlaces(const std::vector<dvec3>& points);

RELEVOFILTERSVOLUME_EXPORT MergedCellPoints MergeCellPoints(const VolumeCells& cells);
}

#endif

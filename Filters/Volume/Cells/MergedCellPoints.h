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

#include <vector>

namespace relevo
{
class VolumeCells;

struct MergedCellPoints
{
  /// For each point the first coincident point.
  std::vector<vtkIdType> Places;
  /// For each point the first coincident point with the same scalars.
  std::vector<vtkIdType> Points;
};

/// Returns for each point the first coincident point.
std::vector<vtkIdType> FindPlaces(const std::vector<dvec3>& points);

RELEVOFILTERSVOLUME_EXPORT MergedCellPoints MergeCellPoints(const VolumeCells& cells);
}

#endif

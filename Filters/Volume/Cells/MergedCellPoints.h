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

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <vector>

namespace relevo
{
class VolumeCells;

/// Returns for each point the first coincident point, or the point itself if the scalars differ.
RELEVOFILTERSVOLUME_EXPORT std::vector<vtkIdType> FindMergedPoints(const VolumeCells& cells);
}

#endif

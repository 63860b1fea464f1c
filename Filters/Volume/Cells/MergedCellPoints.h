// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which points of several data sets are one
 *
 * Private to the modules' own sources.
 */
#ifndef MergedCellPoints_h
#define MergedCellPoints_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <vector>

namespace relevo
{
class VolumeCells;

/// For each point the first one at exactly the same place, or itself if that has other scalars.
RELEVOFILTERSVOLUME_EXPORT std::vector<vtkIdType> FindMergedPoints(const VolumeCells& cells);
}

#endif

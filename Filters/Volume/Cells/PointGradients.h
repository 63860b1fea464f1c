// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   scalar gradients at the points of a mesh, used as normals for shading
 *
 * Private to the modules.
 */
#ifndef PointGradients_h
#define PointGradients_h

#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <vector>

namespace relevo
{
class VolumeCells;

/**
 * Returns for each point the volume-weighted mean gradient of the adjacent cells and ghost cells,
 * in scalar units per length. The gradient of a cell is that at its centre. Merged points, see
 * MergeCellPoints(), have the same gradient. It is 0 if no adjacent cell has point scalars.
 */
RELEVOFILTERSVOLUME_EXPORT std::vector<Gradients> ComputePointGradients(const VolumeCells& cells);
/// The same if the merged points are known.
RELEVOFILTERSVOLUME_EXPORT std::vector<Gradients> ComputePointGradients(
  const VolumeCells& cells, const std::vector<vtkIdType>& merged);
}

#endif

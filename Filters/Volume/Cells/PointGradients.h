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

#include <vector>

namespace relevo
{
class VolumeCells;
struct MergedCellPoints;

/**
 * Returns for each point the volume-weighted mean gradient of the adjacent cells and ghost cells,
 * in scalar units per length. The gradient of a cell is that at its centre. Merged points, see
 * MergeCellPoints(), have the same gradient. It is 0 if no adjacent cell has point scalars.
 */
RELEVOFILTERSVOLUME_EXPORT std::vector<Gradients> ComputePointGradients(const VolumeCells& cells);
/// The same for the first components only, if the merged points are known. The components of a
/// point follow each other.
RELEVOFILTERSVOLUME_EXPORT std::vector<dvec3> ComputePointGradients(
  const VolumeCells& cells, const MergedCellPoints& merged, int numberOfComponents);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   gradients of scalars at the points of a mesh, of which shading takes its normals
 *
 * Private to the modules' own sources.
 */
#ifndef PointGradients_h
#define PointGradients_h

#include "Cells/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <vector>

namespace relevo
{
class VolumeCells;

/**
 * For each point the mean of the cells' gradients around, by their volumes, in units of scalars per
 * length. A cell's gradient is its derivative in the middle. Points that are one, see
 * FindMergedPoints(), have one gradient; where no cell with scalars of points is, it is 0.
 */
RELEVOFILTERSVOLUME_EXPORT std::vector<Gradients> ComputePointGradients(const VolumeCells& cells);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   values at points from cell arrays, for isosurfaces
 *
 * Private to the modules.
 */
#ifndef PointAverages_h
#define PointAverages_h

#include "Cells/MeshScalars.h"

#include <string>
#include <vector>

namespace relevo
{
/**
 * If the arrays are of cells, replaces them by the averages of the 3D cells at each point, and
 * returns a warning. Otherwise returns "". Coincident points get the same average, also in several
 * data sets. Hidden cells do not count; ghost cells do. Cells with fill values, or values that are
 * not finite, do not count either. They are hidden in a copy of the data set, and the warning has
 * their number. Points without values get NaN.
 */
RELEVOFILTERSVOLUME_EXPORT std::string AverageAtPoints(std::vector<MeshScalars>& meshes);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   normals where patches meet
 *
 * Private to the module's own sources.
 */
#ifndef CoarseNormals_h
#define CoarseNormals_h

#include "Coarse/CoarseMesh.h"

namespace relevo
{
/// Fills mesh.Normals: at each place the mean of the unit normals that the patches have there.
void ComputeNormals(
  const std::vector<FacePatch>& patches, const ControlPoints& homogeneous, CoarseMesh& mesh);

/// For each point the lowest with the same coordinates.
std::vector<vtkIdType> FindPlaces(const std::vector<CoarsePoint>& points);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   point normals of the coarse mesh
 *
 * Private to the module.
 */
#ifndef CoarseNormals_h
#define CoarseNormals_h

#include "Coarse/CoarseMesh.h"

namespace relevo
{
/// Sets mesh.Normals to the mean unit normal of the patches at each merged point.
void ComputeNormals(
  const std::vector<FacePatch>& patches, const ControlPoints& homogeneous, CoarseMesh& mesh);

/// Returns for each point the lowest index of a coincident point.
std::vector<vtkIdType> FindPlaces(const std::vector<CoarsePoint>& points);
}

#endif

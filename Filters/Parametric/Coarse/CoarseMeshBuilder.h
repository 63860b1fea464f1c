// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   builds the coarse triangles of patches
 *
 * Private to the module's own sources.
 */
#ifndef CoarseMeshBuilder_h
#define CoarseMeshBuilder_h

#include "Coarse/CoarseMesh.h"

namespace relevo
{
CoarseMesh BuildCoarseMesh(const ControlNets& nets, const std::vector<dvec4>& points,
  const ControlPoints& homogeneous, vtkUnstructuredGrid* grid, int minimumPieces);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   triangulation of patches
 *
 * Private to the module.
 */
#ifndef CoarseMeshBuilder_h
#define CoarseMeshBuilder_h

#include "Coarse/CoarseMesh.h"

namespace relevo
{
/// `points` are not multiplied by their weights, `homogeneous` are. Edges are split into at least
/// `minimumPieces`, which is 1 or 2.
CoarseMesh BuildCoarseMesh(const ControlNets& nets, const std::vector<dvec4>& points,
  const ControlPoints& homogeneous, vtkUnstructuredGrid* grid, int minimumPieces);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   output of coarse triangles and patches as VTK arrays
 *
 * Private to the module.
 */
#ifndef PatchOutput_h
#define PatchOutput_h

#include "Coarse/CoarseMesh.h"

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace relevo
{
/// Stores the output described in vtkPatchSurfaceFilter. `points` are not multiplied by their
/// weights, `homogeneous` are. Returns the names of cell arrays that are too short and are dropped.
/// Point arrays must be long enough.
std::vector<std::string> StorePatches(const ControlNets& nets, const std::vector<dvec4>& points,
  const ControlPoints& homogeneous, const CoarseMesh& mesh, vtkUnstructuredGrid* grid,
  vtkPolyData* output);
}

#endif

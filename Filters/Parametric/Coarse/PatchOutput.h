// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   coarse triangles and their patches as VTK's arrays
 *
 * Private to the module's own sources.
 */
#ifndef PatchOutput_h
#define PatchOutput_h

#include "Coarse/CoarseMesh.h"

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace relevo
{
/// What vtkPatchSurfaceFilter tells of its output. `points` are not multiplied with their weights,
/// `homogeneous` are. Returns the names of cell arrays that are left out for being too short; those
/// of points must be long enough.
std::vector<std::string> StorePatches(const ControlNets& nets, const std::vector<dvec4>& points,
  const ControlPoints& homogeneous, const CoarseMesh& mesh, vtkUnstructuredGrid* grid,
  vtkPolyData* output);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how far the surface of a face at a level is from that at its highest level
 */
#ifndef LevelErrors_h
#define LevelErrors_h

#include "Data/MicroMesh.h"
#include "vtkSmartPointer.h"

class vtkFloatArray;
class vtkPolyData;

namespace relevo
{
/**
 * Return the largest distance between points of the face with the same weights, with all its edges
 * at each level from 0 to LargestMicroLevel. Both surfaces are linear on the triangles of the finer
 * grid, so the distance is largest at a point of this grid.
 */
std::array<double, LargestMicroLevel + 1> FindLevelErrors(
  const MicroMesh& mesh, const MicroMesh::Face& face);

/// Read this array. Returns false if the mesh has none of the right size. `errors` has a number per
/// triangle and level.
bool TakeLevelErrors(
  vtkPolyData* mesh, std::vector<std::array<float, LargestMicroLevel + 1>>& errors);

/// Make the cell array MicroMeshLevelErrors. Lengths are rounded up.
vtkSmartPointer<vtkFloatArray> MakeLevelErrors(const MicroMesh& mesh);
}

#endif

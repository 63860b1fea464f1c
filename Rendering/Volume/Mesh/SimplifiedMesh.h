// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SimplifiedMesh
 * @brief   fewer tetrahedra with nearly the same shape and scalars
 *
 * Private to the module.
 */
#ifndef SimplifiedMesh_h
#define SimplifiedMesh_h

#include "vtkSmartPointer.h"     // for the mesh
#include "vtkUnstructuredGrid.h" // for the mesh

#include <atomic>

namespace relevo
{
class VolumeCells;

struct SimplifiedMesh
{
  vtkSmartPointer<vtkUnstructuredGrid> Mesh; // with point scalars; null if it could not be made
  double Error = 0.0;                        // the largest difference of scalars at given points

  /**
   * Split cells into tetrahedra, and collapse edges until about this share of the cells is left.
   * Coincident points are merged, and get the mean of their scalars or of their cells' scalars.
   * Only the first component is used. Can be called from any thread, and gives up if `isOutdated`.
   */
  static SimplifiedMesh Make(
    const VolumeCells& cells, double share, const std::atomic<bool>& isOutdated);
};
}

#endif

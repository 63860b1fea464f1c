// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   where on its grid a pick of the triangles of patches is
 *
 * Private to the module.
 */
#ifndef PickedPatch_h
#define PickedPatch_h

#include "vtkType.h"

class vtkPolyData;

namespace relevo
{
//@{
/**
 * The grid's cell of a triangle, and the coordinates on its patch: of a place in the triangle by
 * parametric coordinates, or of the patch's point that is nearest to a position. -1, and nothing is
 * set, where the mesh has no patch there.
 */
vtkIdType FindPickedPatch(
  vtkPolyData* mesh, vtkIdType triangle, const double place[2], double pcoords[3]);
vtkIdType FindNearestPatch(
  vtkPolyData* mesh, vtkIdType triangle, const double position[3], double pcoords[3]);
//@}
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   maps a pick of a patch's triangle to its grid
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
 * Return the grid's cell of a triangle, and the coordinates on its patch: of a point in the
 * triangle with parametric coordinates, or of the patch's point that is nearest to a position. If
 * the mesh has no patch there, -1 is returned and nothing is set.
 */
vtkIdType FindPickedPatch(
  vtkPolyData* mesh, vtkIdType triangle, const double place[2], double pcoords[3]);
vtkIdType FindNearestPatch(
  vtkPolyData* mesh, vtkIdType triangle, const double position[3], double pcoords[3]);
//@}
}

#endif

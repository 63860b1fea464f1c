// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks and removes points of a mesh
 */
#ifndef MeshPoints_h
#define MeshPoints_h

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/// Throws ViewerError if a cell of a vtkPolyData or vtkUnstructuredGrid refers to a missing point.
/// VTK's filters do not check this.
void CheckCorners(vtkPointSet* mesh);

/// Returns the mesh without unused points and their data, so that they do not affect bounds and
/// ranges. Returns the mesh itself if all points are used.
vtkSmartPointer<vtkPolyData> DropUnusedPoints(vtkPolyData* mesh);

#endif

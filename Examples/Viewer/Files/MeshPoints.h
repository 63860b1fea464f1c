// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the points that the cells of a mesh refer to
 */
#ifndef MeshPoints_h
#define MeshPoints_h

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/// Throws ViewerError where a cell of a vtkPolyData or vtkUnstructuredGrid refers to a point that
/// is not there: VTK's filters do not look.
void CheckCorners(vtkPointSet* mesh);

/// The mesh without points that no cell uses, and without their data: nothing that is not drawn
/// takes part in bounds and ranges. The mesh itself where all are used.
vtkSmartPointer<vtkPolyData> DropUnusedPoints(vtkPolyData* mesh);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the points that a mesh uses
 */
#ifndef MeshPoints_h
#define MeshPoints_h

#include "vtkSmartPointer.h"

class vtkPolyData;

/// The mesh without points that no cell uses, and without their data: nothing that is not drawn
/// takes part in bounds and ranges. The mesh itself where all are used, or cells refer to points
/// that it does not have.
vtkSmartPointer<vtkPolyData> DropUnusedPoints(vtkPolyData* mesh);

#endif

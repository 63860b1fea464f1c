// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Closed surfaces of curved cells, as vtkPatchSurfaceFilter's triangles.
#ifndef RelevoPatchMeshes_h
#define RelevoPatchMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

// Exactly round, rational: about the z axis with radii 2 and 0.5; of radius 1 with a pole at
// either end of the z axis.
vtkSmartPointer<vtkPolyData> RelevoNewPatchTorus();
vtkSmartPointer<vtkPolyData> RelevoNewPatchSphere();

// A Lagrange hexahedron of degree 3 whose faces are bent and meet at creases.
vtkSmartPointer<vtkPolyData> RelevoNewPatchCube();

#endif

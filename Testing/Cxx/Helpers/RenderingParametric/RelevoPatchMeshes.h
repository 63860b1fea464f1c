// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Closed surfaces of curved cells, as triangles of vtkPatchSurfaceFilter.
#ifndef RelevoPatchMeshes_h
#define RelevoPatchMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

// Exactly round rational surfaces: a torus about the z axis with radii 2 and 0.5, and a sphere of
// radius 1 with poles on the z axis.
vtkSmartPointer<vtkPolyData> RelevoNewPatchTorus();
vtkSmartPointer<vtkPolyData> RelevoNewPatchSphere();

// A Lagrange hexahedron of degree 3 with bent faces that meet at creases.
vtkSmartPointer<vtkPolyData> RelevoNewPatchCube();

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Dense meshes, their micro-meshes, and distances between surfaces by sampling.
#ifndef RelevoMicroMeshes_h
#define RelevoMicroMeshes_h

#include "RelevoTestMeshes.h"

namespace RelevoMicroMeshes
{
using RelevoMeshes::Mesh;

// A closed sphere of radius 1 with relief of height 0.04.
Mesh ReliefSphere(int theta, int phi);

// A plate of n x n squares, bent by 90 degrees along x = 0, with waves and a curved border. The
// cell array "Material" is 1 on one side of a curve, and 0 on the other.
Mesh Plate(int n);

// The micro-mesh with this tolerance. Fails the filter's errors with an empty mesh.
Mesh Encode(vtkPolyData* dense, double tolerance, int maximumLevel = 4, double reduction = 0.98,
  const char* materials = nullptr);

// The surface at a level.
Mesh Decode(vtkPolyData* micro, int level);

// The largest distance from corners and centres of triangles of a mesh to another mesh.
double GetDistance(vtkPolyData* from, vtkPolyData* to);

// The number of differences between points, cells and arrays of two meshes.
int CountDifferences(vtkPolyData* a, vtkPolyData* b);
}

#endif

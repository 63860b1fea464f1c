// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes for tests, and their refinement by the filter.
#ifndef RelevoTestMeshes_h
#define RelevoTestMeshes_h

#include "RelevoHeights.h"
#include "RelevoMeshArrays.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

namespace RelevoMeshes
{
using Triangle = std::array<vtkIdType, 3>;

Mesh Make();

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(
  int level, vtkRefinementSurface* surface = nullptr, vtkDisplacement* displacement = nullptr);

// The filter's output.
Mesh Refine(vtkPolyData* input, vtkAdaptiveRefinement* recipe);

Mesh FromTriangles(
  const std::vector<std::array<double, 3>>& points, const std::vector<Triangle>& triangles);

// Gives all triangles separate points, so that points only coincide.
Mesh Explode(vtkPolyData* mesh);

Mesh Sphere(int theta, int phi);

// Radii 1 and 0.5 about the z axis, with exact normals.
Mesh Torus(int u = 14, int v = 9);

// With a texture seam: two coincident points where u is 0 and 1, and many at the poles.
Mesh TexturedSphere(int theta, int phi);

Mesh Plane(int nx, int ny);

// 24 points with split normals and texture coordinates; quads.
Mesh Cube();

// A polygonal base with slanted sides. Normals are split at the rim.
Mesh Cone();

Mesh Strips();

// Edges with three and four faces, a bow-tie vertex, and a face of opposite winding.
Mesh NonManifold();

Mesh Moebius();

// Long thin triangles in all directions around a fan.
Mesh Slivers();

// Vertices, lines, a triangle, a quad, a hexagon and a strip, some with shared points.
Mesh Mixed();

// The mesh with scaled and translated points of this data type.
Mesh Moved(vtkPolyData* mesh, double scale, const double offset[3], int dataType);

// A flat grid with alternating points at 0 and -0.
Mesh NegativeZeros();
}

#endif

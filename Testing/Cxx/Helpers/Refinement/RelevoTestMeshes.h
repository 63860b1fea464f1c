// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that the tests share, and what the filter makes of them.
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

// Every triangle with points of its own: nothing but coincident points.
Mesh Explode(vtkPolyData* mesh);

Mesh Sphere(int theta, int phi);

// Of radii 1 and 0.5 about the z axis, with its exact normals.
Mesh Torus(int u = 14, int v = 9);

// With a texture seam: two points per place where u is 0 and 1, many at the poles.
Mesh TexturedSphere(int theta, int phi);

Mesh Plane(int nx, int ny);

// 24 points: split normals and texture coordinates; quads.
Mesh Cube();

// A polygonal base and slanted sides, normals split at its rim.
Mesh Cone();

Mesh Strips();

// Three and four faces on an edge, a bow-tie vertex, a face of the wrong orientation.
Mesh NonManifold();

Mesh Moebius();

// Long thin triangles in all directions around a fan.
Mesh Slivers();

// Vertices, lines, a triangle, a quad, a hexagon and a strip, some sharing points.
Mesh Mixed();

// The same mesh with every point moved, in double coordinates if `dataType` says so.
Mesh Moved(vtkPolyData* mesh, double scale, const double offset[3], int dataType);

// A flat grid with points at 0 and -0 by turns.
Mesh NegativeZeros();
}

#endif

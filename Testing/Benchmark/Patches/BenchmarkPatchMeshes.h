// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   curved cells to measure with, and the recipe that refines them
 */
#ifndef BenchmarkPatchMeshes_h
#define BenchmarkPatchMeshes_h

#include "vtkSmartPointer.h"

class vtkAdaptiveRefinement;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace BenchmarkPatchMeshes
{
/// The teapot of RELEVO_TEST_DATA, else a torus of rational patches.
vtkSmartPointer<vtkUnstructuredGrid> MakeTeapot();

/// side x side x side cubic Lagrange hexahedra, bent, with the active scalars "Values".
vtkSmartPointer<vtkUnstructuredGrid> MakeHexahedra(int side);

/// The same with nodes of its own for each cell: vtkDataSetSurfaceFilter takes edges between the
/// same two points for one, though at a border that is one point they are several.
vtkSmartPointer<vtkUnstructuredGrid> Part(vtkUnstructuredGrid* grid);

/// The coarse triangles that carry the patches of a grid, as few as can be, or split ones.
vtkSmartPointer<vtkPolyData> MakePatches(vtkUnstructuredGrid* grid, bool split = false);

/// What vtkDataSetSurfaceFilter makes of a grid.
vtkSmartPointer<vtkPolyData> MakeEvenSurface(vtkUnstructuredGrid* grid, int level);

/// Whole numbers of segments, as many as an error in pixels asks for, up to level 7.
vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(double pixels);
}

#endif

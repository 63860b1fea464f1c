// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   curved cells for measurements, and their recipe
 */
#ifndef BenchmarkPatchMeshes_h
#define BenchmarkPatchMeshes_h

#include "vtkSmartPointer.h"

class vtkAdaptiveRefinement;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace BenchmarkPatchMeshes
{
/// The teapot of RELEVO_TEST_DATA, or a torus of rational patches.
vtkSmartPointer<vtkUnstructuredGrid> MakeTeapot();

/// side x side x side cubic Lagrange hexahedra, bent, with the active scalars "Values".
vtkSmartPointer<vtkUnstructuredGrid> MakeHexahedra(int side);

/// The same grid with separate nodes for each cell: vtkDataSetSurfaceFilter treats edges between
/// the same two points as one, although at a collapsed border they are several.
vtkSmartPointer<vtkUnstructuredGrid> Part(vtkUnstructuredGrid* grid);

/// The coarse triangles that carry the patches of a grid, as few as possible, or split ones.
vtkSmartPointer<vtkPolyData> MakePatches(vtkUnstructuredGrid* grid, bool split = false);

/// The output of vtkDataSetSurfaceFilter for a grid.
vtkSmartPointer<vtkPolyData> MakeEvenSurface(vtkUnstructuredGrid* grid, int level);

/// Whole numbers of segments for an error in pixels, up to level 7.
vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(double pixels);
}

#endif

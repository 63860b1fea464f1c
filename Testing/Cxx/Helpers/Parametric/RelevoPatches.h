// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Single cells of all kinds, and the patches of vtkPatchSurfaceFilter, evaluated by the binomial
// formula.
#ifndef RelevoPatches_h
#define RelevoPatches_h

#include "RelevoSplines.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <string>
#include <vector>

// One cell whose nodes are moved from their regular positions by up to a share of its size. It has
// the point array "Values" with 2 components and, for rational Bézier cells, "RationalWeights".
// `nodes` is only needed if type and degrees do not determine it.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewCell(int type, const std::array<int, 3>& degrees,
  double share, bool isRational = false, vtkIdType nodes = 0);

// An angle bracket of three unit cubes made of quadratic tetrahedra, bent by up to `bend`. The
// point array "Field" has 2 components.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewBracket(double bend = 0.0);

// For types of any degree.
vtkIdType RelevoGetNumberOfNodes(int type, const std::array<int, 3>& degrees);

vtkSmartPointer<vtkPolyData> RelevoMakePatches(vtkUnstructuredGrid* grid, bool split = false);

int RelevoGetNumberOfPatches(vtkPolyData* mesh);
bool RelevoIsTriangle(vtkPolyData* mesh, int patch);

// Evaluates "PatchPoints" without a name, otherwise "PatchNodes:<name>".
std::vector<double> RelevoEvaluatePatch(
  vtkPolyData* mesh, int patch, double u, double v, const std::string& name = "");

// Largest distance of patches from a grid's cells relative to their size, or with `name`, of that
// array's values. Infinite if VTK has no formula for a patch's cell.
double RelevoGetCellError(
  vtkUnstructuredGrid* grid, vtkPolyData* mesh, const std::string& name = "");

#endif

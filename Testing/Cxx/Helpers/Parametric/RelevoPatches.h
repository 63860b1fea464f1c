// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Single cells of all kinds, and the patches that vtkPatchSurfaceFilter makes, evaluated by the
// binomial formula.
#ifndef RelevoPatches_h
#define RelevoPatches_h

#include "RelevoSplines.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <string>
#include <vector>

// One cell whose nodes are moved by up to a share of its size from where its type has them. Point
// arrays "Values" (2 components) and, of Bézier's kinds if isRational, "RationalWeights". `nodes`
// is needed where neither type nor degrees tell.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewCell(int type, const std::array<int, 3>& degrees,
  double share, bool isRational = false, vtkIdType nodes = 0);

// An angle bracket of three unit cubes in quadratic tetrahedra, bent by up to `bend`. The point
// array "Field" has 2 components.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewBracket(double bend = 0.0);

// Of types of any degree.
vtkIdType RelevoGetNumberOfNodes(int type, const std::array<int, 3>& degrees);

vtkSmartPointer<vtkPolyData> RelevoMakePatches(vtkUnstructuredGrid* grid, bool split = false);

int RelevoGetNumberOfPatches(vtkPolyData* mesh);
bool RelevoIsTriangle(vtkPolyData* mesh, int patch);

// "PatchPoints" if there is no name, else "PatchNodes:<name>".
std::vector<double> RelevoEvaluatePatch(
  vtkPolyData* mesh, int patch, double u, double v, const std::string& name = "");

// The largest distance of patches from a grid's cells, relative to their size; with `name`, of
// that array's values. Patches whose cell VTK has no formula for count as infinity.
double RelevoGetCellError(
  vtkUnstructuredGrid* grid, vtkPolyData* mesh, const std::string& name = "");

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Grids of line cells, and what vtkAdaptiveCurveFilter makes of them.
#ifndef RelevoCurves_h
#define RelevoCurves_h

#include "RelevoSplines.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

class vtkAdaptiveCurveFilter;

/// Points in double without cells.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewGrid(const std::vector<RelevoPosition>& points);

/// A filter of a recipe of its own, whose MaximumLevel is `level` and which has no metric.
vtkSmartPointer<vtkAdaptiveCurveFilter> RelevoNewCurveFilter(vtkDataObject* input, int level);

/// The points of a polygon or a line.
std::vector<RelevoPosition> RelevoGetCellPoints(vtkPolyData* mesh, vtkIdType cell);

/// Where points of equal coordinates are one: how many edges have no partner that runs the other
/// way. 0 for closed surfaces that are wound alike.
int RelevoCountOpenEdges(vtkPolyData* mesh);

/// Positive where the triangles look outwards.
double RelevoGetVolume(vtkPolyData* mesh);

#endif

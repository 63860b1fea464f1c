// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Grids of line cells, and the output of vtkAdaptiveCurveFilter for them.
#ifndef RelevoCurves_h
#define RelevoCurves_h

#include "RelevoSplines.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

class vtkAdaptiveCurveFilter;

/// Points in double precision, without cells.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewGrid(const std::vector<RelevoPosition>& points);

/// A filter whose recipe has MaximumLevel `level` and no metric.
vtkSmartPointer<vtkAdaptiveCurveFilter> RelevoNewCurveFilter(vtkDataObject* input, int level);

/// The points of a polygon or a line.
std::vector<RelevoPosition> RelevoGetCellPoints(vtkPolyData* mesh, vtkIdType cell);

/// Number of edges without a partner in the opposite direction, after merging coincident points. It
/// is 0 for closed surfaces of consistent winding.
int RelevoCountOpenEdges(vtkPolyData* mesh);

/// Positive if the triangles face outwards.
double RelevoGetVolume(vtkPolyData* mesh);

#endif

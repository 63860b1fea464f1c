// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   curved line cells as poly-lines, which views can deliver
 *
 * A poly-line has the nodes of a curve as points, in VTK's order. Private arrays have the type of
 * each cell and the weight of each node. Poly-lines without these arrays are linear.
 *
 * Private to the module.
 */
#ifndef CurveLines_h
#define CurveLines_h

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace relevo
{
//@{
/// Return poly-lines for the line cells of a data set, except for ghosts, with its data and the
/// original ids of cells and points.
vtkSmartPointer<vtkPolyData> MakeCurveLines(vtkUnstructuredGrid* grid);
vtkSmartPointer<vtkPolyData> MakeCurveLines(vtkPolyData* mesh);
//@}

/// Return the curves of the lines of a mesh.
vtkSmartPointer<vtkUnstructuredGrid> MakeCurveGrid(vtkPolyData* lines);
}

#endif

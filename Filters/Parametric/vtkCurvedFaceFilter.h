// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCurvedFaceFilter
 * @brief   extract the outer faces of curved cells as 2D cells of the same degrees
 *
 * The output has the 2D cells of a vtkUnstructuredGrid and the outer faces of its 3D cells, whose
 * points are counter-clockwise from outside. It takes much less memory than the grid, and
 * vtkPatchSurfaceFilter generates the same patches from both. Cells have these types:
 * VTK_TRIANGLE, VTK_QUAD and VTK_POLYGON, VTK_QUADRATIC_QUAD and VTK_BIQUADRATIC_TRIANGLE, and
 * Lagrange and Bézier triangles and quadrilaterals for other nodes. Strips become triangles. Points
 * and lines are ignored, and so are hidden cells.
 *
 * Only the points of faces are kept, in the order of the grid. Point and cell arrays are those of
 * the grid, with "vtkOriginalPointIds" and "vtkOriginalCellIds" (vtkIdType), and
 * "HigherOrderDegrees" if there are Lagrange or Bézier cells. Global ids of cells become an
 * ordinary array. Ghost cells keep vtkGhostType.
 *
 * The errors are those of vtkPatchSurfaceFilter for invalid cells, which are skipped. Arrays with
 * too few tuples are dropped with a warning.
 *
 * @sa vtkPatchSurfaceFilter vtkDataSetSurfaceFilter
 */
#ifndef vtkCurvedFaceFilter_h
#define vtkCurvedFaceFilter_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class RELEVOFILTERSPARAMETRIC_EXPORT vtkCurvedFaceFilter : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCurvedFaceFilter* New();
  vtkTypeMacro(vtkCurvedFaceFilter, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkCurvedFaceFilter();
  ~vtkCurvedFaceFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkCurvedFaceFilter(const vtkCurvedFaceFilter&) = delete;
  void operator=(const vtkCurvedFaceFilter&) = delete;

  int Extract(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output);
};

#endif

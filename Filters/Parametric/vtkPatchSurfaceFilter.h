// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchSurfaceFilter
 * @brief   extract the surface of curved cells, as coarse triangles with Bézier patches
 *
 * Each face becomes a Bézier patch of the same surface, up to rounding: a quadrilateral with
 * degrees from 1 to 8 in each direction, or a triangle. Faces are 2D cells and the outer faces of
 * 3D cells, for which u x v points outwards. The filter supports VTK's linear cells (polygons and
 * strips become triangles), quadratic cells, and Lagrange and Bézier cells ("HigherOrderDegrees",
 * "RationalWeights"). Points and lines are ignored. Faces that share the nodes of an edge get
 * patches with bitwise identical control points along it.
 *
 * The output is a vtkPolyData:
 *
 * - Points (double) are corners of patches and points that split an edge. Point arrays are those of
 *   the grid, with integers rounded, and "Normals" (float), the mean of the exact normals of the
 *   patches at a point.
 * - Triangles: two for a quadrilateral and one for a triangle, unless an edge must be split. A
 *   closed edge is split into four pieces, and edges between the same two points into two pieces
 *   each. Cell arrays are those of the grid, "vtkOriginalCellIds" (vtkIdType), the grid's cell,
 *   "PatchIds" (int), the patch, and "PatchCoordinates" (float, 6 components), u and v of the
 *   corners. If a border degenerates to a point, as at the lid of the teapot, a triangle can have
 *   two coincident corners.
 * - Field data are those of the grid and the following arrays. "Patches" (vtkIdType, 4 components)
 *   has the cell type, VTK_BEZIER_QUADRILATERAL or VTK_BEZIER_TRIANGLE, both degrees and the first
 *   control point. "PatchPoints" (double, 4 components) has x, y, z, not multiplied by the weight,
 *   and the weight. "PatchNodes:NAME" (double) has the coefficients of each numeric point array
 *   NAME in the basis of the patch, which is rational if weights differ. A quadrilateral of degrees
 *   p and q has q + 1 rows of p + 1 control points along u. A triangle of degree p has rows j = 0
 *   to p of p - j + 1 control points, where (i, j) belongs to u^i v^j (1 - u - v)^(p - i - j).
 *   "PatchInnerBorders" (int) exists if polygons were cut into triangles: the sum of 1, 2 and 4 for
 *   the borders v = 0, u = 0 and u + v = 1 inside of the polygon.
 *
 * Ghost cells keep vtkGhostType. Hidden cells are ignored.
 *
 * The filter reports the first invalid cell and the number of others, and skips them: cells of an
 * unsupported type, with a wrong number of nodes, with degrees above 8, with weights that are not
 * positive, or with points that do not exist or are not finite. It issues a warning with the number
 * of patches without area, which are skipped, and for arrays with too few tuples, which are
 * dropped.
 *
 * @sa vtkBezierPatchReader vtkNURBSSource vtkDataSetSurfaceFilter
 */
#ifndef vtkPatchSurfaceFilter_h
#define vtkPatchSurfaceFilter_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names

class vtkUnstructuredGrid;

class RELEVOFILTERSPARAMETRIC_EXPORT vtkPatchSurfaceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkPatchSurfaceFilter* New();
  vtkTypeMacro(vtkPatchSurfaceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set whether each patch is cut into a fan, of 8 triangles for a quadrilateral and 6 for a
   * triangle, instead of the smallest possible number of triangles; off by default. This generates
   * about four times as many coarse triangles, but culls more off-screen geometry in close-ups.
   */
  vtkSetMacro(SplitPatches, bool);
  vtkGetMacro(SplitPatches, bool);
  vtkBooleanMacro(SplitPatches, bool);
  //@}

protected:
  vtkPatchSurfaceFilter();
  ~vtkPatchSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPatchSurfaceFilter(const vtkPatchSurfaceFilter&) = delete;
  void operator=(const vtkPatchSurfaceFilter&) = delete;

  bool SplitPatches = false;

  int Convert(vtkUnstructuredGrid* input, vtkPolyData* output);
  void RemoveShortArrays(vtkUnstructuredGrid* grid);
  void WarnOfShortArray(const std::string& name);
};

#endif

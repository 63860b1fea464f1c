// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchSurfaceFilter
 * @brief   the surface of a grid of curved cells, as coarse triangles that carry Bézier patches
 *
 * Each face becomes a Bézier patch that is the same surface, but for rounding: a quadrilateral of
 * degrees 1 to 8, each direction its own, or a triangle. Faces are surface cells, and the outer
 * ones of solid cells, whose patches have u x v outwards. Taken are VTK's linear cells (polygons
 * and strips as triangles), its quadratic ones, and Lagrange's and Bézier's
 * ("HigherOrderDegrees", "RationalWeights"). Points and lines are left out without a word.
 * Where neighbours have an edge's nodes in common their patches have the edge's control points in
 * common, to the bit.
 *
 * Output: a vtkPolyData.
 * - Points (double): corners of patches, and places that edges are split at. Its arrays are the
 *   grid's, integers rounded; "Normals" (float) has for each place the mean of the patches' true
 *   normals.
 * - Triangles, two of a quadrilateral, one of a triangle, more where edges had to be split: one
 *   that is closed in four, and ones that join the same two points in two each. Arrays of cells:
 *   the grid's; "vtkOriginalCellIds" (vtkIdType), the grid's cell; "PatchIds" (int), the patch;
 *   "PatchCoordinates" (float, 6 components), u and v of the triangle's corners. Where a border of
 *   a patch is one place, as at the teapot's lid, a triangle has two points there.
 * - Field data: the grid's, and "Patches" (vtkIdType, 4 components): VTK_BEZIER_QUADRILATERAL or
 *   VTK_BEZIER_TRIANGLE, both degrees, and the first control point. "PatchPoints" (double, 4
 *   components): x, y, z, not multiplied with the weight, and the weight. "PatchNodes:NAME"
 *   (double) for each numeric array NAME of points: its coefficients in the patch's own, maybe
 *   rational, basis. Control points of a quadrilateral of degrees p and q are q + 1 rows of p + 1
 *   along u; those of a triangle rows j = 0 to p of p - j + 1: (i, j) belongs to
 *   u^i v^j (1 - u - v)^(p - i - j). "PatchInnerBorders" (int), where polygons have been cut into
 *   triangles: the sum of 1, 2 and 4 for borders v = 0, u = 0 and u + v = 1 inside the polygon.
 *
 * Cells that are ghosts keep vtkGhostType; hidden ones are as if they were not there.
 *
 * Errors name the first such cell and how many others there are; the rest is put out: cells of a
 * type that patches cannot be made of; with a wrong number of nodes; of degrees above 8; with
 * weights of 0 or less; with points that are not finite or not there. Warnings: how many patches
 * have no area and are left out; arrays that have too few tuples, which are left out.
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
   * Whether all patches are cut into fans, 8 triangles for a quadrilateral and 6 for a triangle,
   * rather than into as few triangles as there can be; off by default. Faces out of view are then
   * culled more finely, as when the camera comes near, for about four times the coarse triangles.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceIntersectionFilter
 * @brief   intersect two surfaces, or a surface with itself, with exact predicates
 *
 * Inputs 0 and 1: vtkPolyData, each transformed by a matrix, see SetMatrix(). Polygons are split
 * into fans (0, i, i + 1), as in VTK's mappers, and strips into triangles. Vertices, lines and
 * ghost cells (vtkDataSetAttributes::DUPLICATECELL) are ignored. Coincident points of an input are
 * merged. Without input 1, input 0 is intersected with itself. Adjacent triangles then only
 * intersect where they meet outside of their common corner or edge.
 *
 * Whether triangles intersect is decided exactly, for the transformed points as doubles. Touching
 * is intersecting. Points of the result are exact quotients, rounded once. All triangles with the
 * same point share it, so that curves of closed surfaces are closed, unless they bound an overlap
 * or end where surfaces only touch.
 *
 * Output 0, the curves, is a vtkPolyData with a line segment for each pair of triangles that
 * intersect in one, and vertices where surfaces touch in one point. Output 1, the overlaps, has
 * polygons where coplanar triangles overlap, with the orientation of input 0. Points of both are
 * doubles in the transformed space. The cell arrays "Input0CellID" and "Input1CellID"
 * (vtkIdTypeArray) are the ids of the intersecting cells. Without input 1, both belong to input 0
 * and the lower one is first. If several pairs of triangles have the same intersection, the output
 * contains it once, with the first pair (use AllPairsOn() to get the others). Segments with
 * overlaps on both sides are omitted, and so are vertices at the end of a segment or at a corner of
 * an overlap.
 *
 * Outputs 2 and 3 are the inputs, not transformed, with the cell array "Contact" (unsigned char): 0
 * for free, 2 for cells that intersect the other surface. SetClassify() adds other values. Output 3
 * is empty without input 1.
 *
 * The bounding box trees are cached until the points, polygons, strips or ghost cells of an input
 * change. Another matrix only updates their boxes. Work is distributed with vtkSMPTools; the number
 * of threads does not change the result.
 *
 * The filter reports an error with the number of the input, and produces empty outputs, if an input
 * has no polygons or strips; a cell refers to a point that does not exist; a point, original or
 * transformed, is not finite or exceeds 1e300; a matrix is singular, not affine or not finite; or a
 * recipe cannot be applied. It issues a warning with the number of triangles without area, which
 * are skipped, and, with Classify, for a surface that is not closed.
 *
 * @sa vtkIntersectionPolyDataFilter vtkCollisionDetectionFilter
 */
#ifndef vtkSurfaceIntersectionFilter_h
#define vtkSurfaceIntersectionFilter_h

#include "RelevoFiltersIntersectionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for members
#include <vector> // for cells

class vtkAdaptiveRefinement;
class vtkMatrix4x4;

namespace relevo
{
class MovedSurface;
class Motion;
}

class RELEVOFILTERSINTERSECTION_EXPORT vtkSurfaceIntersectionFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceIntersectionFilter* New();
  vtkTypeMacro(vtkSurfaceIntersectionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of the array "Contact".
  enum ContactType
  {
    FREE,
    NEAR_BY,
    CUT,
    INSIDE
  };

  //@{
  /**
   * Set the matrix that transforms an input (0 or 1): affine; nullptr (default) for none. The
   * filter detects modifications of the matrix. Products are computed in double as in vtkTransform.
   */
  void SetMatrix(int input, vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetMatrix(int input);
  //@}

  //@{
  /**
   * Set a recipe that refines an input (0 or 1); nullptr (default) to use the flat triangles. With
   * a recipe, the filter intersects the curved and displaced surface of
   * vtkAdaptiveRefinementFilter. It is refined to Tolerance where the surfaces can meet: at faces
   * whose bounds intersect the other surface or its bounds. The metric of the recipe is ignored.
   * Without input 1, and with Classify, the whole surface is refined. Cell ids and outputs 2 and 3
   * are those of the coarse cells.
   */
  void SetRefinement(int input, vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement(int input);
  //@}

  //@{
  /**
   * Set the largest distance between the triangles and the surface of a recipe, in the transformed
   * space; at least 0. 0 (default) uses as many segments per edge as the recipe's MaximumLevel
   * allows. A warning is issued if MaximumLevel is not sufficient. The distance is measured at the
   * centroids of triangles and the midpoints of their sides, with at least 16 segments per coarse
   * edge. With a height map, it is measured at each texel, with up to 2^(MaximumLevel + 1)
   * segments.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  //@}

  /**
   * Return the triangles of an input with a recipe that were last intersected, not transformed. The
   * cell array "vtkOriginalCellIds" (vtkIdTypeArray) has the ids of the coarse cells. Returns
   * nullptr without a recipe or without that input.
   */
  vtkPolyData* GetRefinedSurface(int input);

  //@{
  /**
   * Set whether segments are joined to poly-lines of maximum length; off by default. A poly-line
   * ends at points that do not have exactly two segments. The last point of a closed poly-line is
   * its first point. Output 0 then has the cell array "ComponentId" (vtkIdTypeArray), which numbers
   * connected curves and vertices from 0. Cell ids are -1 if the segments of a poly-line belong to
   * different cells.
   */
  vtkSetMacro(JoinSegments, bool);
  vtkGetMacro(JoinSegments, bool);
  vtkBooleanMacro(JoinSegments, bool);
  //@}

  //@{
  /**
   * Set whether the field data of output 0 list all pairs of intersecting cells once, sorted, as
   * "AllInput0CellID" and "AllInput1CellID" (vtkIdTypeArray); off by default. Curves and overlaps
   * only have the first pair of cells that intersect in the same segment, vertex or polygon.
   * Without input 1, both ids belong to input 0 and the lower one is first. With a recipe they are
   * ids of coarse cells.
   */
  vtkSetMacro(AllPairs, bool);
  vtkGetMacro(AllPairs, bool);
  vtkBooleanMacro(AllPairs, bool);
  //@}

  //@{
  /**
   * Set whether cells of outputs 2 and 3 are classified by their distance from the other surface;
   * off by default. It has no effect without input 1. The cell array "Distance" (double) is the
   * smallest distance from the other surface in the transformed space: 0 for cells that intersect
   * it, and -1 for cells without area. "Contact" of other cells is 3 inside of the other surface,
   * if that is closed, or else 1 if the distance is less than ContactDistance. A surface is closed
   * if each edge has exactly two triangles. If it is not closed, no cell is classified as inside.
   */
  vtkSetMacro(Classify, bool);
  vtkGetMacro(Classify, bool);
  vtkBooleanMacro(Classify, bool);
  //@}

  //@{
  /**
   * Set the distance below which Classify marks cells as near; at least 0. With 0 (default), no
   * cell is near.
   */
  void SetContactDistance(double distance);
  vtkGetMacro(ContactDistance, double);
  //@}

#ifndef __VTK_WRAP__
  /**
   * Share the transformed triangles of an input without a recipe with other filters that have the
   * same input and matrix. By default (nullptr), the filter has separate triangles.
   */
  void ShareSurface(int input, std::shared_ptr<relevo::MovedSurface> surface);
#endif

  /// Return how many times a bounding box tree was built.
  vtkGetMacro(NumberOfTreeBuilds, int);

  /// Include the modification times of matrices and recipes.
  vtkMTimeType GetMTime() override;

protected:
  vtkSurfaceIntersectionFilter();
  ~vtkSurfaceIntersectionFilter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfaceIntersectionFilter(const vtkSurfaceIntersectionFilter&) = delete;
  void operator=(const vtkSurfaceIntersectionFilter&) = delete;

  struct Internals;

  bool IsInput(int input);
  bool TakeInput(int side, vtkPolyData* input);
  bool TakeSurface(
    int side, vtkPolyData* mesh, const std::vector<vtkIdType>& cells, const relevo::Motion& motion);
  bool RefineInput(int side);
  void WarnOfOpenSurfaces();
  bool Report(double progress);
  bool Intersect(vtkPolyData* inputs[2], vtkInformationVector* outputVector);

  vtkSmartPointer<vtkMatrix4x4> Matrices[2];
  vtkSmartPointer<vtkAdaptiveRefinement> Refinements[2];
  double Tolerance = 0.0;
  bool JoinSegments = false;
  bool AllPairs = false;
  bool Classify = false;
  double ContactDistance = 0.0;
  int NumberOfTreeBuilds = 0;
  std::unique_ptr<Internals> Surfaces;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceIntersectionFilter
 * @brief   where two surfaces meet, or one meets itself, decided exactly
 *
 * Inputs 0 and 1: vtkPolyData, each moved by its matrix, see SetMatrix(). Polygons are taken as the
 * fans (0, i, i + 1) that VTK's mappers draw, strips as their triangles; vertices, lines and ghost
 * cells (vtkDataSetAttributes::DUPLICATECELL) do not meet anything. Points that coincide in an
 * input are one. Without input 1, input 0 is intersected with itself: triangles that share a corner
 * or an edge meet there, and count only where they meet beyond it.
 *
 * Whether triangles meet is decided exactly for the doubles that the moved points are; touching
 * counts. Points of the result are exact quotients that are rounded once. Each is one point for all
 * triangles that have it in common, so that curves of closed surfaces are closed, unless they bound
 * an overlap or end where surfaces only touch.
 *
 * Output 0, curves: vtkPolyData of line segments, one for each two triangles that have one in
 * common, and vertices where surfaces only touch in a point. Output 1, overlaps: polygons that two
 * triangles in one plane have in common, winding as that of input 0. Points of both are doubles,
 * moved as the inputs are. Their cell arrays "Input0CellID" and "Input1CellID" (vtkIdTypeArray) are
 * the ids of the cells that meet; without input 1 both are of input 0, the lower one first. What
 * several pairs of triangles have in common is there once, with the first of them (AllPairsOn()
 * adds the others); segments that have overlaps on both sides are left out, as are vertices at the
 * end of a segment or at a corner of an overlap.
 *
 * Outputs 2 and 3: the inputs, not moved, with the cell array "Contact" (unsigned char): 0 free, 2
 * cut, which is to say that it meets the other surface. With Classify more, see there. Output 3 is
 * empty without input 1.
 *
 * Trees of boxes are built when an input's points, polygons, strips or ghost cells have changed,
 * and stay as long as these do: with another matrix only their boxes are computed anew. Runs on all
 * processors that vtkSMPTools uses; their number does not change the result.
 *
 * Errors, with empty outputs, name the input: one without polygons and strips; cells that refer to
 * points that do not exist; points, also moved ones, that are not finite or beyond 1e300; a matrix
 * that is singular, not affine or not finite; a recipe that cannot be applied. Warnings, one each:
 * triangles without an area, which are left out, and how many; with Classify, a surface that is not
 * closed.
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

  /// What the array "Contact" says of a cell.
  enum ContactType
  {
    FREE,
    NEAR_BY,
    CUT,
    INSIDE
  };

  //@{
  /**
   * What moves the points of an input, 0 or 1: affine, default nullptr, which leaves them where
   * they are. Changes of the matrix count. Products are computed in double as vtkTransform has it.
   */
  void SetMatrix(int input, vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetMatrix(int input);
  //@}

  //@{
  /**
   * What an input, 0 or 1, is the coarse mesh of: default nullptr, its flat triangles. With a
   * recipe its surface is intersected, curved and displaced as vtkAdaptiveRefinementFilter makes
   * it, and refined to Tolerance where the two can meet, whatever the recipe's metric says: at
   * faces whose bounds meet the other surface, or its bounds. Without input 1, and with Classify,
   * it is refined all over. Cell ids and outputs 2 and 3 are those of the coarse cells.
   */
  void SetRefinement(int input, vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement(int input);
  //@}

  //@{
  /**
   * The largest distance between the triangles that are intersected and the surface of a recipe, a
   * length where the matrices have moved it: at least 0. By default 0, for edges of as many
   * segments as the recipe's MaximumLevel allows. Where that is not enough there is a warning. The
   * distance is measured, from the middles of triangles and of their sides at least, in 16 parts of
   * a coarse edge or more; with a height map at each of its texels, up to 2^(MaximumLevel + 1).
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  //@}

  /**
   * The triangles of an input with a recipe that were intersected last, not moved, with the cell
   * array "vtkOriginalCellIds" (vtkIdTypeArray) of the coarse cells; nullptr without a recipe or
   * without that input.
   */
  vtkPolyData* GetRefinedSurface(int input);

  //@{
  /**
   * Whether segments become poly-lines, as long as can be; default off. They end where not just two
   * segments meet; a closed one has its first point also as its last. Output 0 then has the cell
   * array "ComponentId" (vtkIdTypeArray), which counts the connected curves and the vertices from
   * 0; cell ids are -1 where a line has segments of different cells.
   */
  vtkSetMacro(JoinSegments, bool);
  vtkGetMacro(JoinSegments, bool);
  vtkBooleanMacro(JoinSegments, bool);
  //@}

  //@{
  /**
   * Whether the field data of output 0 have the arrays "AllInput0CellID" and "AllInput1CellID"
   * (vtkIdTypeArray) of every pair of cells that meet, once, sorted; default off. Curves and
   * overlaps name only the first pair of those that meet in the same segment, vertex or polygon.
   * Without input 1 both are of input 0, the lower id first; with a recipe they are coarse cells.
   */
  vtkSetMacro(AllPairs, bool);
  vtkGetMacro(AllPairs, bool);
  vtkBooleanMacro(AllPairs, bool);
  //@}

  //@{
  /**
   * Whether cells of outputs 2 and 3 are also told how far they are from the other surface; default
   * off, and without effect without input 1. The cell array "Distance" (double) is the least
   * distance to the other surface, where both are moved: 0 where cut, -1 of cells without triangles
   * that have an area. "Contact" of cells that are not cut is 3 for those inside of the other
   * surface, where it is closed, 1 for others that are nearer than ContactDistance. A surface is
   * closed when each edge is of exactly two triangles; of one that is not, inside is not told.
   */
  vtkSetMacro(Classify, bool);
  vtkGetMacro(Classify, bool);
  vtkBooleanMacro(Classify, bool);
  //@}

  //@{
  /**
   * Nearer than this cells are near, with Classify; at least 0, default 0: none is.
   */
  void SetContactDistance(double distance);
  vtkGetMacro(ContactDistance, double);
  //@}

#ifndef __VTK_WRAP__
  /**
   * Have the moved triangles of an input that has no recipe in common with other filters that have
   * the same input and the same matrix; by default (nullptr) they are the filter's own.
   */
  void ShareSurface(int input, std::shared_ptr<relevo::MovedSurface> surface);
#endif

  /// How often a tree was built so far.
  vtkGetMacro(NumberOfTreeBuilds, int);

  /// Includes the modification times of matrices and recipes.
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

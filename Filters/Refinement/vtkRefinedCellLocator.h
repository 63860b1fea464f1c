// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinedCellLocator
 * @brief   find intersections and nearest points of a refined surface without building it
 *
 * This cell locator takes a coarse vtkPolyData, see SetDataSet(), and searches its refined and
 * displaced surface. Results lie on the surface that vtkAdaptiveRefinementFilter would create. Cell
 * ids and parametric coordinates are those of the coarse cells. Only the faces that a query needs
 * are refined, so that a line takes microseconds. Vertices and lines of the data set are found
 * unchanged.
 *
 * Use it wherever VTK takes a vtkAbstractCellLocator. You do not need it for
 * vtkAdaptiveRefinementMapper, where VTK's pickers find the refined surface without a locator. If
 * you draw the coarse mesh with vtkPolyDataMapper, add this locator with
 * vtkCellPicker::AddLocator() to pick the refined surface.
 *
 * The recipe provides the levels for Camera, ModelToWorld and ViewportSize, as in the filter. The
 * first query builds the search structure. It is rebuilt when the data set or the recipe changes,
 * and for view-dependent metrics when the camera changes. After a call of BuildLocator(), several
 * threads can query at once.
 *
 * Coordinates are those of the data set. The locator reports an error and finds nothing if there is
 * no data set or it is not a vtkPolyData, if there is no recipe, if depth-tags or texture
 * coordinates cannot be used, or if a metric or height map fails.
 *
 * @sa vtkAdaptiveRefinementFilter vtkAdaptiveRefinementMapper
 */
#ifndef vtkRefinedCellLocator_h
#define vtkRefinedCellLocator_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkAbstractCellLocator.h"
#include "vtkSmartPointer.h"  // for members
#include "vtkVersionMacros.h" // for ForceBuildLocator()

#include <memory> // for Internals

class vtkAdaptiveRefinement;
class vtkCamera;
class vtkMatrix4x4;
class vtkPoints;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
}

class RELEVOFILTERSREFINEMENT_EXPORT vtkRefinedCellLocator : public vtkAbstractCellLocator
{
public:
  static vtkRefinedCellLocator* New();
  vtkTypeMacro(vtkRefinedCellLocator, vtkAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the recipe. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  //@{
  /**
   * Set the camera for view-dependent metrics, in world coordinates. There is none by default.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Set the matrix from the data set's coordinates to world coordinates, for example an actor's
   * GetMatrix(). The default is the identity.
   */
  void SetModelToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetModelToWorld();
  //@}

  //@{
  /**
   * Set the width and height of the viewport in pixels. The default is (300, 300). Values less than
   * 1 are rejected with an error.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  /**
   * Return the time of the latest change of the locator or its recipe. If the metric depends on
   * Camera or ModelToWorld, their times count too.
   */
  vtkMTimeType GetMTime() override;

  using vtkAbstractCellLocator::FindClosestPoint;
  using vtkAbstractCellLocator::FindClosestPointWithinRadius;
  using vtkAbstractCellLocator::IntersectWithLine;

  /**
   * Find the first intersection of the line from p1 to p2 with the refined surface or with vertices
   * and lines. Points within the distance `tol` of the line count too. Returns 1 if there is one
   * and sets its parameter t in [0, 1] along the line, its coordinates, the coarse cell and the
   * parametric coordinates there. In a strip, `subId` is the triangle. `cell` is reversed if needed
   * so that it faces as the refined surface does at that point.
   */
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;

  //@{
  /**
   * Find all intersections of the line from p1 to p2 with the refined surface, and all vertices and
   * lines within `tol` of it, ordered along the line, with their coarse cells. If the line misses
   * the surface, the first surface point within `tol` is used. `points` and `cellIds` may be
   * nullptr, and `cell` is not used. The overloads with `tol` return 1 if they find a point. The
   * overload without `tol` uses 0. It returns -1 if the line hits the back of the surface first,
   * which means that p1 is inside a closed surface, 1 if it hits the front, and 0 if it finds
   * nothing.
   */
  int IntersectWithLine(
    const double p1[3], const double p2[3], vtkPoints* points, vtkIdList* cellIds) override;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, vtkPoints* points,
    vtkIdList* cellIds) override;
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, vtkPoints* points,
    vtkIdList* cellIds, vtkGenericCell* cell) override;
#else
  int IntersectWithLine(
    const double p1[3], const double p2[3], double tol, vtkPoints* points, vtkIdList* cellIds);
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, vtkPoints* points,
    vtkIdList* cellIds, vtkGenericCell* cell);
#endif
  //@}

  //@{
  /**
   * Find the point of the refined surface, or of vertices and lines, that is nearest to x, with its
   * squared distance and its coarse cell. The cell id is -1 if nothing is found. `inside` is 1 if
   * the point is not on the border of its coarse triangle. Polygons are split into triangles.
   */
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkGenericCell* cell,
    vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2, int& inside) override;
  //@}

  //@{
  /**
   * Find the coarse cells whose refined surface may intersect a box (xmin, xmax, ymin, ymax, zmin,
   * zmax) or lie within `tolerance` of a line. The result contains all these cells and may contain
   * nearby ones.
   */
  void FindCellsWithinBounds(double* bbox, vtkIdList* cells) override;
  void FindCellsAlongLine(
    const double p1[3], const double p2[3], double tolerance, vtkIdList* cells) override;
  //@}

  //@{
  /**
   * Build the search structure if it is out of date, or free it.
   */
  void BuildLocator() override;
  void FreeSearchStructure() override;
  //@}
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  /**
   * Rebuild the search structure even if it is up to date.
   */
  void ForceBuildLocator() override;
#endif

  /**
   * Fill `pd` with the output of vtkAdaptiveRefinementFilter for the data set. `level` is ignored.
   */
  void GenerateRepresentation(int level, vtkPolyData* pd) override;

protected:
  vtkRefinedCellLocator();
  ~vtkRefinedCellLocator() override;

private:
  vtkRefinedCellLocator(const vtkRefinedCellLocator&) = delete;
  void operator=(const vtkRefinedCellLocator&) = delete;

  struct vtkInternals;

  relevo::RefinementView MakeView() const;
  bool UpdateSurface();
  bool Prepare(vtkPolyData* input);
  /// Implements IntersectWithLine() without `tol`.
  int FindHits(
    const double p1[3], const double p2[3], double tol, vtkPoints* points, vtkIdList* cellIds);
  int IntersectOtherCells(const double p1[3], const double p2[3], double tol, double& t,
    double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell);

  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> ModelToWorld;
  int ViewportSize[2] = { 300, 300 };
  std::unique_ptr<vtkInternals> Internals;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinedCellLocator
 * @brief   lines and nearest points on a surface that a recipe refines, without refining it
 *
 * A cell locator of a coarse vtkPolyData, SetDataSet(), whose answers are those of its refined,
 * displaced surface: places on what vtkAdaptiveRefinementFilter would make, cell ids and parametric
 * coordinates of the coarse cells. Only the faces that a query needs are refined, so that a line
 * takes microseconds. Vertices and lines of the data set are found as they are.
 *
 * For whatever takes a vtkAbstractCellLocator. vtkAdaptiveRefinementMapper needs none: VTK's
 * pickers find the refined surface there by themselves. With a vtkPolyDataMapper of the coarse
 * mesh, vtkCellPicker::AddLocator() makes the picker find the refined surface.
 *
 * Levels are those that the recipe gives for Camera, ModelToWorld and ViewportSize, as in the
 * filter. The search structure is built by the first query, and again whenever the data set, the
 * recipe or, for metrics that depend on the view, the camera has changed. BuildLocator() builds it
 * beforehand; after it, several threads can query at once.
 *
 * Coordinates are those of the data set. Errors (ErrorEvent; nothing is found): no data set or one
 * that is not a vtkPolyData, no recipe, depth-tags or texture coordinates that cannot be used, a
 * metric or height map that fails.
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
   * What to refine to. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  //@{
  /**
   * The camera for metrics that depend on the view, in world coordinates; none by default.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * From the data set's coordinates to the world's, an actor's GetMatrix(); identity by default.
   */
  void SetModelToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetModelToWorld();
  //@}

  //@{
  /**
   * Width and height of the viewport in pixels, (300, 300) by default. Less than 1 is an error.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  /**
   * Latest change of the locator, its recipe or, for metrics that depend on them, Camera and
   * ModelToWorld.
   */
  vtkMTimeType GetMTime() override;

  using vtkAbstractCellLocator::FindClosestPoint;
  using vtkAbstractCellLocator::FindClosestPointWithinRadius;
  using vtkAbstractCellLocator::IntersectWithLine;

  /**
   * The first point where the line from p1 to p2 meets the refined surface, or passes it within
   * `tol`, a length; of vertices and lines as well. Fills where on the line, in [0, 1], the point,
   * the coarse cell with its parametric coordinates (of the triangle `subId` in a strip), and
   * `cell`, turned so that it faces as the refined surface does there. Returns 1 if there is one.
   */
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;

  //@{
  /**
   * All points where the line from p1 to p2 meets the refined surface, and vertices and lines
   * within `tol` of it, in the line's order, with their coarse cells; where there is none of the
   * surface, the first that the line passes within `tol`. `points` or `cellIds` may be nullptr,
   * `cell` is not used. With `tol` returns 1 if there is one. Without, `tol` is 0, and the result
   * is -1 if the first point is met from behind, that is if p1 lies inside a closed surface, 1 if
   * from the front, 0 if there is none.
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
   * The point of the refined surface, or of vertices and lines, that is nearest to x, the square of
   * its distance, and its coarse cell, -1 where there is none. `inside` is 1 where the point is not
   * on the border of its coarse cell.
   */
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkGenericCell* cell,
    vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2, int& inside) override;
  //@}

  //@{
  /**
   * Coarse cells that the refined surface may have points of in a box (xmin, xmax, ymin, ymax,
   * zmin, zmax), or within `tolerance` of a line: all that have, and some that come near.
   */
  void FindCellsWithinBounds(double* bbox, vtkIdList* cells) override;
  void FindCellsAlongLine(
    const double p1[3], const double p2[3], double tolerance, vtkIdList* cells) override;
  //@}

  //@{
  /**
   * Build the search structure if something has changed; free it.
   */
  void BuildLocator() override;
  void FreeSearchStructure() override;
  //@}
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  /**
   * Build all of it anew, though nothing says that it has changed.
   */
  void ForceBuildLocator() override;
#endif

  /**
   * What vtkAdaptiveRefinementFilter makes of the data set; `level` has no meaning here.
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
  /// As IntersectWithLine() without `tol`.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshVisibilitySort
 * @brief   3D cells in the order in which they hide each other, by their common faces
 *
 * For whatever takes a vtkVisibilitySort, as vtkProjectedTetrahedraMapper::SetVisibilitySort(). The
 * meshed polyhedra visibility ordering for non-convex meshes, MPVO-NC (P. Williams, "Visibility
 * Ordering Meshed Polyhedra", ACM Transactions on Graphics 11, 1992): of two cells with a common
 * face, the one on the viewer's side of its plane comes after the other, or before it with
 * SetDirectionToFrontToBack(). vtkCellCenterDepthSort, by centres of cells, errs wherever cells are
 * of uneven sizes or shapes.
 *
 * Input: a vtkDataSet, of which all 3D cells come exactly once, ghost, blanked and empty ones
 * included; other cells never come. Faces are common where their corners are at the same places,
 * whatever the ids of points are, and also where the diagonal of a quadrilateral is not the same on
 * both sides, or is on one side alone. Faces that are not flat count as their mean planes, curved
 * ones by their corners.
 *
 * The order is right in a convex mesh of convex cells that hide each other in no circle; the camera
 * may be inside it. Not guaranteed is the order of cells across gaps, where a mesh is concave,
 * hollow or in parts, and across faces of three cells or more: there, faces of the border that the
 * camera sees count by the distances of their centres. Where cells hide each other in a circle, one
 * of the faces is ignored, and GetNumberOfCycles() says how often.
 *
 * What is known of the mesh is kept as long as the input is unchanged; InitTraversal() then takes
 * linear time, and b log b for b faces of the border. Faces are tested on all processors that
 * vtkSMPTools uses; their number does not change the order. Coordinates that are not finite order
 * nothing: such cells come, too.
 *
 * Errors, and then no cells: no input or no camera; cells with points that the input lacks; more
 * than 2^31 - 1 points, cells, or faces of cells. Without 3D cells no cells come.
 *
 * @sa vtkVisibilitySort vtkCellCenterDepthSort vtkProjectedTetrahedraMapper
 */
#ifndef vtkMeshVisibilitySort_h
#define vtkMeshVisibilitySort_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkVisibilitySort.h"

#include <memory> // for Internals

class RELEVOFILTERSVOLUME_EXPORT vtkMeshVisibilitySort : public vtkVisibilitySort
{
public:
  static vtkMeshVisibilitySort* New();
  vtkTypeMacro(vtkMeshVisibilitySort, vtkVisibilitySort);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Sorts the cells for the camera, the model transform and the direction as they are now.
   */
  void InitTraversal() override;

  /**
   * The ids of the next cells, at most MaxCellsReturned; nullptr after the last ones. The array is
   * overwritten by the next call.
   */
  vtkIdTypeArray* GetNextCells() override;

  /**
   * Faces that were ignored by the last InitTraversal(), because the cells that hide each other
   * across them do so in a circle.
   */
  vtkIdType GetNumberOfCycles();

protected:
  vtkMeshVisibilitySort();
  ~vtkMeshVisibilitySort() override;

private:
  vtkMeshVisibilitySort(const vtkMeshVisibilitySort&) = delete;
  void operator=(const vtkMeshVisibilitySort&) = delete;

  bool Build();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

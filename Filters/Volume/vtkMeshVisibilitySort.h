// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshVisibilitySort
 * @brief   sort 3D cells by visibility, using their common faces
 *
 * Use this with classes that take a vtkVisibilitySort, for example
 * vtkProjectedTetrahedraMapper::SetVisibilitySort(). It implements MPVO-NC, the meshed polyhedra
 * visibility ordering for non-convex meshes (P. Williams, "Visibility Ordering Meshed Polyhedra",
 * ACM Transactions on Graphics 11, 1992): of two cells with a common face, the cell on the viewer's
 * side of the face comes last, or first with SetDirectionToFrontToBack(). vtkCellCenterDepthSort,
 * which compares cell centres, is wrong for cells of different sizes or shapes.
 *
 * The input is a vtkDataSet. Each 3D cell is returned exactly once, including ghost, blanked and
 * empty cells. Other cells are not returned. Two faces are common if their corners coincide. Their
 * point ids may differ. A quadrilateral may also have different diagonals on the two sides, or a
 * diagonal on one side only. Faces that are not flat are replaced by their mean planes, and curved
 * faces by their corners.
 *
 * The order is correct for a convex mesh of convex cells without visibility cycles, even if the
 * camera is inside the mesh. It is not guaranteed across gaps, where a mesh is concave, hollow or
 * has separate parts, and across faces that three or more cells share. In these cases, border faces
 * that the camera sees are compared by the distances of their centres. In a visibility cycle, one
 * of the faces is ignored; see GetNumberOfCycles().
 *
 * The connectivity is cached until the input changes. InitTraversal() then takes linear time, plus
 * b log b for b border faces. Work is distributed with vtkSMPTools; the number of threads does not
 * change the order. Cells with coordinates that are not finite are returned at any position.
 *
 * The class reports an error and returns no cells if there is no input or no camera; a cell refers
 * to a point that does not exist; or there are more than 2^31 - 1 points, cells or cell faces.
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
   * Sort the cells for the current camera, model transform and direction.
   */
  void InitTraversal() override;

  /**
   * Return the ids of the next cells, at most MaxCellsReturned, or nullptr after the last cell. The
   * next call overwrites the array.
   */
  vtkIdTypeArray* GetNextCells() override;

  /**
   * Return the number of faces that the last InitTraversal() ignored to break visibility cycles.
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
